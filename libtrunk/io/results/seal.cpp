#include "results/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>

#include "errors/input_error.hpp"
#include "files/sha256.hpp"

namespace trunk {
namespace {

constexpr std::string_view begin = "sha256 ";
constexpr std::size_t seal_size = begin.size() + 64 + 1;

/// Returns `size` bytes at `offset`; fewer if the file ends before.
std::string bytes_at(const std::filesystem::path& path, std::uintmax_t offset, std::size_t size) {
  std::string bytes(size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// The first bytes of HDF5 as we write it: signature, version of the superblock, … address of the end of
/// HDF5.
struct Superblock {
  static constexpr std::size_t size = 48, version_at = 8, end_at = 28;
  std::string bytes;

  /// Older versions have no checksums, and HDF5 1.10 crashes on damaged ones (measured: 3 of 1500).
  bool is_ours() const { return bytes[version_at] == 2 || bytes[version_at] == 3; }
  std::uint64_t end_of_hdf5() const {
    std::uint64_t end = 0;
    std::memcpy(&end, bytes.data() + end_at, sizeof end);
    return end;
  }
};

/// Returns whether the name of one of our schemas stands near the beginning, where the root group is. HDF5 is
/// not asked, since it may crash on such a file.
bool holds_our_schema(const std::filesystem::path& path) {
  constexpr std::size_t near = 1'000'000;
  const std::string bytes = bytes_at(path, 0, near);
  for (const char* schema : {"trunk.run", "trunk.fit", "trunk.sweep"})
    if (bytes.find(schema) != std::string::npos) return true;
  return false;
}

}  // namespace

std::string seal_of(std::span<const std::byte> hdf5) {
  const std::string_view bytes(reinterpret_cast<const char*>(hdf5.data()), hdf5.size());
  return std::string(begin) + sha256_of_text(bytes) + "\n";
}

void require_intact(const std::filesystem::path& path) {
  const std::uintmax_t size = std::filesystem::file_size(path);
  const auto refuse = [&](const std::string& found, const std::string& expected, const std::string& remedy) {
    throw InputError({path.string()}, found, expected, remedy);
  };
  const std::string repeat = "use another copy or make the file again";
  const std::string damaged = "is damaged: its bytes have changed since it was written";
  const std::string seal = size < seal_size ? "" : bytes_at(path, size - seal_size, seal_size);
  if (seal.starts_with(begin)) {
    if (sha256_of_file(path, size - seal_size) != seal.substr(begin.size(), 64) || seal.back() != '\n')
      refuse(damaged, "", repeat);
    return;
  }
  const Superblock head{bytes_at(path, 0, Superblock::size)};
  if (head.bytes.size() < Superblock::size)
    refuse(fmt::format("is truncated: it has only {} bytes", size), "", repeat);
  if (!head.is_ours()) {
    if (holds_our_schema(path))
      refuse(
          "holds results of trunk, but another program such as h5repack has rewritten it in an older format",
          "the file as trunk wrote it", "use the original here; other programs can read this copy");
    refuse("is an HDF5 file of another program", "a results file of trunk", "");
  }
  const std::uint64_t end = head.end_of_hdf5();
  if (size == end) return;
  if (size >= end + seal_size) refuse(damaged, "", repeat);
  refuse(fmt::format("is truncated: it has {} of {} bytes", size, end + seal_size), "", repeat);
}

}  // namespace trunk
