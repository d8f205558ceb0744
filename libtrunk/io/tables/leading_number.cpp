#include "tables/leading_number.hpp"

#include <algorithm>
#include <limits>

#include "tables/text_cells.hpp"

namespace trunk {

LeadingNumber leading_number(std::string_view text) {
  text = trimmed(text);
  for (const std::string_view sign : {std::string_view("\xC2\xB1"), std::string_view("+/-")})
    if (text.starts_with(sign)) text = trimmed(text.substr(sign.size()));
  constexpr std::string_view digits = "0123456789";
  std::size_t end = std::min(text.find_first_not_of("0123456789.,+-"), text.size());
  if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const std::size_t exponent = end + (text[end + 1] == '-' || text[end + 1] == '+' ? 2 : 1);
    const std::size_t after = std::min(text.find_first_not_of(digits, exponent), text.size());
    if (after > exponent) end = after;
  }
  const auto [value, error] = cell_number(text.substr(0, end), true);
  if (error != std::errc{}) return {std::numeric_limits<double>::quiet_NaN(), std::string(text)};
  return {value, std::string(trimmed(text.substr(end)))};
}

}  // namespace trunk
