#include "text/encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace trunk {
namespace {

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

// Broken surrogate pairs become U+FFFD. They can occur in names and comments, but not in numbers.
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

// Our choice: within the first 4 kB, at least nine in ten bytes at one parity are zero, and none at the
// other.
enum class Parity { none, even, odd };
Parity zeros(std::string_view bytes) {
  const std::size_t pairs = std::min<std::size_t>(bytes.size(), 4096) / 2;
  if (pairs < 4) return Parity::none;
  std::size_t even = 0, odd = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    even += bytes[2 * i] == '\0' ? 1 : 0;
    odd += bytes[2 * i + 1] == '\0' ? 1 : 0;
  }
  if (odd * 10 >= pairs * 9 && even == 0) return Parity::odd;
  if (even * 10 >= pairs * 9 && odd == 0) return Parity::even;
  return Parity::none;
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto lead = static_cast<unsigned char>(bytes[i++]);
    if (lead < 0x80) continue;
    const std::size_t tails = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
    if (lead < 0xC2 || lead > 0xF4 || i + tails > bytes.size()) return false;
    for (std::size_t end = i + tails; i < end; ++i)
      if ((static_cast<unsigned char>(bytes[i]) & 0xC0) != 0x80) return false;
  }
  return true;
}

// Microsoft's code page 1252 from 0x80 to 0x9F. Above 0x9F, it equals ISO 8859-1.
constexpr std::array<char16_t, 32> windows_1252{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::string decode_windows_1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(text, byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80U] : byte);
  }
  return text;
}

}  // namespace

bool encoding_is_a_guess(std::string_view bytes) {
  return !bytes.starts_with("\xFF\xFE") && !bytes.starts_with("\xFE\xFF") && zeros(bytes) == Parity::none &&
         !is_utf8(bytes);
}

std::string utf8_of(std::string bytes) {
  using namespace std::string_view_literals;
  const std::string_view view = bytes;
  if (view.starts_with("\xEF\xBB\xBF"sv)) return bytes.substr(3);
  if (view.starts_with("\xFF\xFE"sv)) return decode_utf16(view.substr(2), false);
  if (view.starts_with("\xFE\xFF"sv)) return decode_utf16(view.substr(2), true);
  if (const Parity parity = zeros(view); parity != Parity::none)
    return decode_utf16(view, parity == Parity::even);
  if (is_utf8(view)) return bytes;
  return decode_windows_1252(view);
}

}  // namespace trunk
