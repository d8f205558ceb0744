#include "commands/text/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

namespace trunk {
namespace {

struct Title {
  std::string_view name, text;
};

constexpr std::array titles = {
    Title{"r_ei", "muscle against recoil at end-inspiration"},
    Title{"recoil_time_s", "recoil time"},
    Title{"k_muscle_over_k_elasticity", "muscle stiffness over tissue stiffness"},
    Title{"k_elasticity", "tissue stiffness, k_elasticity"},
    Title{"k_muscle", "muscle stiffness, k_muscle"},
    Title{"excursion_right_mm", "right dome descends"},
    Title{"excursion_left_mm", "left dome descends"},
    Title{"delta_l_mm", "zone of apposition shortens"},
    Title{"delta_h_mm", "domes flatten"},
    Title{"end_expiratory_above_relaxation_ml", "end-expiratory volume above relaxation"},
    Title{"abdominal_elastance_cmH2O_per_L", "abdominal elastance"},
    Title{"lung_elastance_cmH2O_per_L", "lung elastance"},
    Title{"respiratory_elastance_cmH2O_per_L", "respiratory elastance"},
    Title{"resistance_cmH2O_s_per_L", "resistance of airway and lung"},
    Title{"intrinsic_peep_cmH2O", "intrinsic PEEP"},
    Title{"gastric_swing_cmH2O", "gastric swing"},
    Title{"pleural_swing_cmH2O", "pleural swing"},
    Title{"transdiaphragmatic_swing_cmH2O", "transdiaphragmatic swing"}};

constexpr const char* verdict_mark = "*";

/// Writes a number down to the digit of 10^power.
std::string down_to(double value, int power) {
  if (!std::isfinite(value)) return "no limit";
  const double unit = std::pow(10.0, power);
  return power < 0 ? fmt::format("{:.{}f}", value, -power)
                   : fmt::format("{:.0f}", std::round(value / unit) * unit);
}

/// Returns the power of ten of the last digit that an interval leaves; none if it has no finite side.
std::optional<int> last_digit(const FitResult& r) {
  std::optional<double> shorter;
  for (const double side : {r.value - r.lower95, r.upper95 - r.value})
    if (std::isfinite(side) && side > 0.0) shorter = std::min(side, shorter.value_or(side));
  if (!shorter) return std::nullopt;
  return static_cast<int>(std::floor(std::log10(*shorter))) - 1;
}

/// Numbers the assumptions and reasons of results in the order in which they appear. What the verdict says
/// already has a star instead of a number.
class Footnotes {
 public:
  explicit Footnotes(const std::string& verdict) : verdict_(verdict) {}

  /// Returns "(1)", or "(1, 2)" for two assumptions, which a semicolon separates.
  std::string assumptions(const std::string& text) {
    std::set<std::size_t> numbers;
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t to = std::min(text.find("; ", from), text.size());
      numbers.insert(number_of(text.substr(from, to - from)));
      from = to + 2;
    }
    return fmt::format("({})", fmt::join(numbers, ", "));
  }

  std::string reason(const std::string& text) {
    return verdict_.find(text) == std::string::npos ? fmt::format("({})", number_of(text)) : verdict_mark;
  }

  std::string text() const {
    std::string out;
    for (std::size_t i = 0; i < all_.size(); ++i) out += fmt::format("  ({}) {}\n", i + 1, sentence(all_[i]));
    return out;
  }

 private:
  std::size_t number_of(const std::string& part) {
    const auto at = std::find(all_.begin(), all_.end(), part);
    const auto index = static_cast<std::size_t>(at - all_.begin());
    if (at == all_.end()) all_.push_back(part);
    return index + 1;
  }

  static std::string sentence(std::string part) {
    part.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(part.front())));
    return part.ends_with('.') || part.ends_with('?') ? part : part + ".";
  }

  const std::string& verdict_;
  std::vector<std::string> all_;
};

std::string grade_text(const FitResult& r, Footnotes& notes) {
  switch (r.grade) {
    case Grade::determined:
      return "determined";
    case Grade::assumption:
      return "assumes " + notes.assumptions(r.assumption);
    case Grade::not_determined:
      return r.reason.empty() ? "not determined" : "not determined " + notes.reason(r.reason);
    case Grade::not_converged:
      break;
  }
  return "not converged";
}

std::string without_end_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// Whether the interval spans more than four powers of ten (our choice).
bool knows_nothing(const FitResult& r) {
  return r.lower95 > 0.0 && std::isfinite(r.upper95) && r.upper95 > 1e4 * r.lower95;
}

std::string straight_value(const FitResult& r) {
  if (!std::isfinite(r.value)) return "withheld";
  if (knows_nothing(r)) return "not determined";
  return down_to(r.value, last_digit(r).value_or(-2));
}

/// Returns what straight lines give for a result; "" if they say nothing of it.
std::string straight_text(const FitResults& results, const std::string& name) {
  if (results.straight)
    for (const FitResult& r : results.straight->results)
      if (r.name == name) return straight_value(r);
  return "";
}

}  // namespace

std::string title_of(const std::string& result) {
  for (const Title& title : titles)
    if (title.name == result) return std::string(title.text);
  return result;
}

std::string interval_text(const FitResult& r) {
  if (!std::isfinite(r.value)) return "withheld";
  const std::string unit = r.unit == "1" ? "" : " " + r.unit;
  if (knows_nothing(r)) return fmt::format("{:.2g}{} (not known)", r.value, unit);
  const auto power = last_digit(r);
  if (!power) return fmt::format("{:.3g}{}", r.value, unit);
  return fmt::format("{} ({} to {}){}", down_to(r.value, *power), down_to(r.lower95, *power),
                     down_to(r.upper95, *power), unit);
}

std::string verdict_text(const FitResults& results) {
  const bool marked = std::any_of(results.results.begin(), results.results.end(), [&](const FitResult& r) {
    return !r.reason.empty() && results.verdict.find(r.reason) != std::string::npos;
  });
  return (marked ? fmt::format("{} ", verdict_mark) : "") + results.verdict;
}

std::string results_table(const FitResults& results) {
  if (results.headline.empty()) return "";
  Footnotes notes(results.verdict);
  std::string text = without_end_blanks(fmt::format("  {:<41} {:<28} {:<19} {}", "", "value (95 % interval)",
                                                    "grade", results.straight ? "straight lines" : "")) +
                     "\n";
  for (const std::string& name : results.headline) {
    const FitResult& r = *results.find(name);
    text += without_end_blanks(fmt::format("  {:<41} {:<28} {:<19} {}", title_of(name), interval_text(r),
                                           grade_text(r, notes), straight_text(results, name)));
    text += (std::isfinite(r.value) ? fmt::format("\n      {}\n", r.meaning) : "\n");
  }
  text += notes.text();
  if (results.straight && results.gates.empty())
    text += fmt::format(
        "  straight lines: what the paper assumes of the activation (residual {:.2g} % of tidal volume)\n",
        100.0 * results.straight->nrmse);
  return text;
}

}  // namespace trunk
