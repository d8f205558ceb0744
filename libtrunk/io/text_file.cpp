#include "io/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

void check_is_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError(path.string(), 0, "no such file; expected a readable text file; check the path");
  if (std::filesystem::is_directory(status))
    throw InputError(path.string(), 0, "this is a directory; expected a text file; give a file inside it");
}

// Reads piece by piece instead of asking for the size, so that a pipe is bounded as well.
std::string read_bytes(const std::filesystem::path& path, std::size_t max_bytes) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw InputError(path.string(), 0,
                     "cannot be opened (" + std::generic_category().message(errno) +
                         "); expected a readable text file; check its permissions");
  std::string bytes;
  std::string piece(std::size_t{1} << 16, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    bytes.append(piece, 0, static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > max_bytes)
      throw InputError(path.string(), 0,
                       "the file is longer than " + std::to_string(max_bytes / 1'000'000) +
                           " MB, the most this program reads; cut or thin it");
  }
  if (file.bad()) throw InputError(path.string(), 0, "reading failed half way; check the disk or the pipe");
  return bytes;
}

void append_utf8(std::string& text, char32_t code) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | (code >> 12));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

// Broken surrogate pairs become U+FFFD: only names and comments can hold them, numbers never do.
std::string decode_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const char32_t code = unit(i);
    const bool high = code >= 0xD800 && code < 0xDC00, low = code >= 0xDC00 && code < 0xE000;
    const char32_t next = high && i + 3 < bytes.size() ? unit(i + 2) : 0;
    if (next >= 0xDC00 && next < 0xE000) {
      append_utf8(text, 0x10000 + ((code - 0xD800) << 10) + (next - 0xDC00));
      i += 2;
    } else {
      append_utf8(text, high || low ? 0xFFFD : code);
    }
  }
  return text;
}

std::string decode(std::string bytes) {
  using namespace std::string_view_literals;
  const std::string_view view = bytes;
  if (view.starts_with("\xEF\xBB\xBF"sv)) return bytes.substr(3);
  if (view.starts_with("\xFF\xFE"sv)) return decode_utf16(view.substr(2), false);
  if (view.starts_with("\xFE\xFF"sv)) return decode_utf16(view.substr(2), true);
  return bytes;
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  check_is_file(path);
  std::string text = decode(read_bytes(path, max_bytes));
  if (text.empty())
    throw InputError(path.string(), 0,
                     "the file is empty; expected text; check that its export was finished");
  if (const auto nul = text.find('\0'); nul != std::string::npos) {
    const auto at = text.begin() + static_cast<std::ptrdiff_t>(nul);
    throw InputError(path.string(), 1 + static_cast<std::size_t>(std::count(text.begin(), at, '\n')),
                     "NUL byte found: this is a binary file or UTF-16 without its mark; expected text; "
                     "export it as CSV in UTF-8");
  }
  return text;
}

}  // namespace trunk
