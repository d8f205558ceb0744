#include "recordings/matlab/require_whole.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

constexpr std::uint32_t compressed = 15;  // miCOMPRESSED (MathWorks, "MAT-File Format")

enum class Unpacked { whole, damaged, too_long };

// Unpacks `bytes` bytes from where the file stands and counts the result. => left
Unpacked unpack(std::ifstream& file, std::uint32_t bytes, std::uint64_t& left) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return Unpacked::damaged;
  std::vector<unsigned char> in(std::size_t{1} << 16), out(std::size_t{1} << 16);
  int state = Z_OK;
  while (state == Z_OK && bytes > 0) {
    const auto piece = std::min<std::uint32_t>(bytes, static_cast<std::uint32_t>(in.size()));
    if (!file.read(reinterpret_cast<char*>(in.data()), piece)) break;
    bytes -= piece;
    stream.next_in = in.data();
    stream.avail_in = piece;
    do {
      stream.next_out = out.data();
      stream.avail_out = static_cast<unsigned>(out.size());
      state = inflate(&stream, Z_NO_FLUSH);
      const std::uint64_t made = out.size() - stream.avail_out;
      if (made > left) {
        inflateEnd(&stream);
        return Unpacked::too_long;
      }
      left -= made;
    } while (state == Z_OK && stream.avail_out == 0);
    if (state == Z_BUF_ERROR) state = Z_OK;  // it wants more bytes
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END ? Unpacked::whole : Unpacked::damaged;
}

}  // namespace

// A version 5 MAT-file is a header of 128 bytes and elements, each with its type and size in front.
void require_whole(const std::filesystem::path& path, std::uint64_t most_bytes) {
  std::ifstream file(path, std::ios::binary);
  const auto read = [&](std::uint64_t at, auto& into) {
    file.seekg(static_cast<std::streamoff>(at));
    return static_cast<bool>(file.read(reinterpret_cast<char*>(&into), sizeof into));
  };
  std::array<char, 4> version_and_order{};
  if (!read(124, version_and_order)) return;
  const bool native = version_and_order[2] == 'I' && version_and_order[3] == 'M';
  const bool swapped = version_and_order[2] == 'M' && version_and_order[3] == 'I';
  const char major = version_and_order[native ? 1 : 0];
  if ((!native && !swapped) || major != 1) return;  // 1 is version 5; 2 is HDF5
  std::error_code unknown;
  const auto size = static_cast<std::uintmax_t>(std::filesystem::file_size(path, unknown));
  if (unknown) return;
  const auto in_order = [&](std::uint32_t word) { return swapped ? __builtin_bswap32(word) : word; };
  for (std::uintmax_t at = 128; at < size;) {
    std::array<std::uint32_t, 2> tag{};  // type, bytes
    const bool complete = size - at >= sizeof tag && read(at, tag);
    const std::uint32_t bytes = in_order(tag[1]);
    if (!complete || bytes > size - at - sizeof tag)
      throw InputError({path.string()}, "the file ends in the middle of a variable", "a whole MAT-file",
                       "copy or save it again");
    if (in_order(tag[0]) == compressed) {
      const Unpacked result = unpack(file, bytes, most_bytes);
      if (result == Unpacked::damaged)
        throw InputError({path.string()},
                         "the MAT-file is damaged: a compressed variable does not match its checksum",
                         "a whole MAT-file", "copy or save it again");
      if (result == Unpacked::too_long)
        throw InputError({path.string()}, "the MAT-file unpacks to more than this program reads",
                         "a smaller file", "save only the signals again");
    }
    at += sizeof tag + bytes;
  }
}

}  // namespace trunk
