#include "files/read_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "errors/input_error.hpp"
#include "text/encoding.hpp"

namespace trunk {
namespace {

void check_is_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError({path.string()}, "no such file", "a readable file", "check the path");
  if (std::filesystem::is_directory(status))
    throw InputError({path.string()}, "this is a directory", "a file", "give a file inside it");
}

// Reads piece by piece instead of asking for the size, so that a pipe is bounded as well.
std::string read_bytes(const std::filesystem::path& path, std::size_t max_bytes) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw InputError({path.string()}, "cannot be opened (" + std::generic_category().message(errno) + ")",
                     "a readable file", "check its permissions");
  std::string bytes;
  std::string piece(std::size_t{1} << 16, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    bytes.append(piece, 0, static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > max_bytes)
      throw InputError({path.string()},
                       "the file is longer than " + std::to_string(max_bytes / 1'000'000) + " MB",
                       "a file of at most this size", "shorten or thin it");
  }
  if (file.bad())
    throw InputError({path.string()}, "reading stopped before the end", "", "check the disk or the pipe");
  return bytes;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  check_is_file(path);
  std::string bytes = read_bytes(path, max_bytes);
  if (bytes.empty())
    throw InputError({path.string()}, "the file is empty", "", "check that its export was finished");
  return bytes;
}

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  check_is_file(path);
  std::string text = utf8_of(read_bytes(path, max_bytes));
  if (text.empty())
    throw InputError({path.string()}, "the file is empty", "text", "check that its export was finished");
  if (const auto nul = text.find('\0'); nul != std::string::npos) {
    const auto at = text.begin() + static_cast<std::ptrdiff_t>(nul);
    throw InputError({path.string(), 1 + static_cast<std::size_t>(std::count(text.begin(), at, '\n'))},
                     "NUL byte found: this is a binary file", "text", "export it as CSV in UTF-8");
  }
  return text;
}

}  // namespace trunk
