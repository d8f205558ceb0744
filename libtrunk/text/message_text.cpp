#include "text/message_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace trunk {
namespace {

/// Returns how many bytes the UTF-8 character at the start of the text has; 1 if it is none.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 1;
  if (byte(0) > 0xF4 || bytes > text.size()) return 1;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 1;
  // Longer forms than needed, surrogates, and numbers beyond Unicode are none either.
  if (bytes > 2 && ((byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) >= 0xA0) ||
                    (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) >= 0x90)))
    return 1;
  return bytes;
}

}  // namespace

std::string number_text(double value, int digits) {
  // Large numbers keep their digits: 1400, not 1.4e+03.
  const bool large = std::abs(value) >= std::pow(10.0, digits - 1) && std::abs(value) < 1e15;
  const auto format = large ? std::chars_format::fixed : std::chars_format::general;
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, format, large ? 0 : digits);
  return error == std::errc{} ? std::string(buffer, end) : std::string("?");
}

std::string without_controls(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view character = text.substr(i, character_bytes(text.substr(i)));
    const auto first = static_cast<unsigned char>(character[0]);
    const bool is_c1 = character.size() == 2 && first == 0xC2 &&
                       static_cast<unsigned char>(character[1]) < 0xA0;  // U+0080 to U+009F
    if (first == '\n')
      clean += ' ';
    else if (is_c1 || first < 0x20 || first == 0x7F || (first >= 0x80 && character.size() == 1))
      clean += '?';
    else
      clean += character;
    i += character.size();
  }
  return clean;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 40;
  const auto continues_character = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  std::size_t length = std::min(text.size(), most);
  // Do not cut a UTF-8 character in two.
  while (length < text.size() && length > 0 && continues_character(length)) --length;
  std::string shown(text.substr(0, length));
  return "'" + without_controls(shown) + (length < text.size() ? "...'" : "'");
}

}  // namespace trunk
