#include "files/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "errors/input_error.hpp"
#include "text/encoding.hpp"
#include "text/named_encoding.hpp"

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

// Returns the number of the line, from 1, in which a byte is.
std::size_t line_at(std::string_view bytes, std::size_t place) {
  return 1 + static_cast<std::size_t>(
                 std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

std::string decoded_or_refused(const std::filesystem::path& path, std::string_view bytes,
                               const std::string& encoding, std::size_t max_bytes) {
  Decoded result = decoded(bytes, encoding, max_bytes);
  const std::string option = "--encoding " + encoding;
  if (!result.known_name)
    throw InputError({option}, "no encoding of this name is known",
                     "a name such as UTF-8, Shift_JIS, GB18030, EUC-KR, windows-1250 or KOI8-R",
                     "`iconv -l` lists all of them");
  if (result.bad_byte)
    throw InputError({path.string(), line_at(bytes, *result.bad_byte)},
                     fmt::format("byte {:#04x} is not {} text",
                                 static_cast<unsigned char>(bytes[*result.bad_byte]), encoding),
                     "a text in this encoding", "give the right " + option.substr(0, 10));
  if (result.too_long)
    throw InputError({path.string()},
                     "the text is longer than " + std::to_string(max_bytes / 1'000'000) + " MB",
                     "a file of at most this size", "shorten or thin it");
  return std::move(result.text);
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
  return read_text_file_in("", path, max_bytes).text;
}

TextOfFile read_text_file_in(const std::string& encoding, const std::filesystem::path& path,
                             std::size_t max_bytes) {
  check_is_file(path);
  std::string bytes = read_bytes(path, max_bytes);
  const bool guess = encoding.empty() && encoding_is_a_guess(bytes);
  std::string text =
      encoding.empty() ? utf8_of(std::move(bytes)) : decoded_or_refused(path, bytes, encoding, max_bytes);
  if (text.empty())
    throw InputError({path.string()}, "the file is empty", "text", "check that its export was finished");
  if (const auto nul = text.find('\0'); nul != std::string::npos)
    throw InputError({path.string(), line_at(text, nul)}, "NUL byte found: this is a binary file", "text",
                     "export it as CSV in UTF-8");
  return {std::move(text), guess};
}

}  // namespace trunk
