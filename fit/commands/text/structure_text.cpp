#include "commands/text/structure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trunk {

std::string structure_table(const Structure& s, const std::vector<std::string>& numbers) {
  std::string text;
  if (!s.choices.empty()) {
    text = fmt::format("  {:<20} {:>22}", "choice of the model", "range");
    for (const std::string& number : numbers) text += fmt::format("  {:>18}", number);
    text += "\n";
  }
  for (std::size_t i = 0; i < s.choices.size(); ++i) {
    const Structure::Choice& c = s.choices[i];
    const std::string unit = c.unit == "1" ? "" : " " + c.unit;
    text += fmt::format("  {:<20} {:>22}", c.name, fmt::format("{:.4g} to {:.4g}{}", c.low, c.high, unit));
    for (const std::string& number : numbers) {
      const auto at = std::find(s.measures.begin(), s.measures.end(), number) - s.measures.begin();
      const double share = s.shares[static_cast<std::size_t>(at) * s.choices.size() + i];
      text += fmt::format("  {:>18}", std::isfinite(share) ? fmt::format("{:.0f} %", 100.0 * share) : "-");
    }
    text += "\n";
  }
  for (const std::string& sentence : s.left_out) text += "  " + sentence + "\n";
  return text;
}

}  // namespace trunk
