#include "text/message_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace trunk {

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
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
    const bool is_c1 = byte == 0xC2 && next >= 0x80 && next < 0xA0;  // U+0080 to U+009F in UTF-8
    if (is_c1) ++i;
    clean += byte == '\n' ? ' ' : is_c1 || byte < 0x20 || byte == 0x7F ? '?' : text[i];
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
