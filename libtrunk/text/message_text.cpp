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

std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 40;
  const auto continues_character = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  std::size_t length = std::min(text.size(), most);
  // Do not cut a UTF-8 character in two.
  while (length < text.size() && length > 0 && continues_character(length)) --length;
  std::string shown(text.substr(0, length));
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  return "'" + shown + (length < text.size() ? "...'" : "'");
}

}  // namespace trunk
