#include "uncertainty/verdict.hpp"

#include <fmt/format.h>

#include "uncertainty/uncertainty.hpp"

namespace trunk {
namespace {

/// "4000 N/m within 3 %", or the interval where a percentage would mean little.
std::string with_interval(const Estimate& e) {
  const double percent = 100.0 * (e.upper95 / e.value - 1.0);
  const std::string unit = e.unit == "1" ? "" : " " + e.unit;
  if (percent < 50.0) return fmt::format("{} = {:.4g}{} within {:.2g} %", e.name, e.value, unit, percent);
  if (percent < 1000.0)
    return fmt::format("{} = {:.3g}{}, anywhere from {:.2g} to {:.2g}", e.name, e.value, unit, e.lower95,
                       e.upper95);
  return fmt::format("{} not at all (uncertain by more than a factor of {})", e.name,
                     e.upper95 / e.value > 1000.0 ? "1000" : "10");
}

}  // namespace

std::string verdict_of(const Uncertainty& u) {
  std::string determined, open;
  const auto add = [](std::string& list, const std::string& item) {
    list += (list.empty() ? "" : "; ") + item;
  };
  const bool ratio_matters = !u.identifiable && u.ratio.identifiable;
  if (ratio_matters) add(determined, with_interval(u.ratio));
  for (const Estimate& e : u.parameters) {
    const std::string text = with_interval(e) + (e.at_bound ? " (stopped at its bound)" : "");
    if (e.identifiable)
      add(determined, text);
    else if (!(ratio_matters && e.name == "k_muscle"))
      add(open, text);
  }
  if (open.empty()) return fmt::format("Determined by this trace, for the damping assumed: {}.", determined);
  return fmt::format(
      "{}{}Not determined by this trace: {}. A deeper and a shallower breath, a longer undisturbed "
      "expiration, or a "
      "measured dome or chest-wall motion would settle it.",
      ratio_matters        ? "Only the ratio is determined: "
      : determined.empty() ? ""
                           : "Determined by this trace: ",
      determined.empty() ? "" : determined + ". ", open);
}

}  // namespace trunk
