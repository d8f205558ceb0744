#include "breaths/plausibility.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

struct Range {
  double low, high, usual;
  bool holds(double value) const { return value >= low && value <= high; }
};

constexpr Range period_s{0.8, 30, 4};
constexpr Range tidal_volume_ml{30, 6000, 500};
constexpr Range infant_volume_ml{5, 30, 15};
constexpr double infant_period_s = 2;  // longer breaths are slower than 30 a minute

struct Unit {
  std::string_view name, words;
  double size;  // in SI
};

constexpr std::array time_units{Unit{"s", "seconds", 1}, Unit{"ms", "milliseconds", s_per_ms},
                                Unit{"min", "minutes", s_per_min}};
constexpr std::array volume_units{Unit{"ml", "millilitres", m3_per_ml}, Unit{"L", "litres", m3_per_litre}};
constexpr std::array flow_units{Unit{"L_s", "litres per second", m3_per_litre},
                                Unit{"L_min", "litres per minute", m3_per_litre / s_per_min},
                                Unit{"ml_s", "millilitres per second", m3_per_ml}};

// Returns a remedy that names the unit with which `found` would be nearest to the usual value, or "" if no
// unit brings it into the range.
template <class Units>
std::string better_unit(const Units& units, std::string_view base, std::string_view used, double found,
                        const Range& range) {
  const Unit* from = nullptr;
  for (const Unit& unit : units)
    if (unit.name == used) from = &unit;
  if (from == nullptr) return "";
  const Unit* best = nullptr;
  const auto corrected = [&](const Unit& unit) { return found * unit.size / from->size; };
  const auto distance = [&](const Unit& unit) { return std::abs(std::log(corrected(unit) / range.usual)); };
  for (const Unit& unit : units)
    if (range.holds(corrected(unit)) && (best == nullptr || distance(unit) < distance(*best))) best = &unit;
  if (best == nullptr) return "";
  return fmt::format(
      "check that the signal is breathing; if it is, the column named in {} may hold {}: name it {}_{}",
      from->words, best->words, base, best->name);
}

}  // namespace

void check_period(const Trace& trace, double median_period_s) {
  if (period_s.holds(median_period_s)) return;
  const auto hint = better_unit(time_units, "time", trace.time_unit, median_period_s, period_s);
  throw InputError({trace.source}, "the median breath lasts " + number_text(median_period_s) + " s",
                   "0.8 to 30 s",
                   hint.empty() ? "check the unit of time and that the signal is breathing" : hint);
}

void check_tidal_volume(const Trace& trace, double median_tidal_volume_m3, double median_period_s,
                        const std::string& change) {
  const double found_ml = median_tidal_volume_m3 * ml_per_m3;
  if (tidal_volume_ml.holds(found_ml)) return;
  if (infant_volume_ml.holds(found_ml) && median_period_s < infant_period_s) return;
  const bool flow = trace.kind == SignalKind::flow;
  const auto hint = flow ? better_unit(flow_units, "flow", trace.value_unit, found_ml, tidal_volume_ml)
                         : better_unit(volume_units, "volume", trace.value_unit, found_ml, tidal_volume_ml);
  throw InputError({trace.source}, "the median breath has a tidal volume of " + number_text(found_ml) + " ml",
                   "30 to 6000 ml, or 5 ml and more in breaths under 2 s",
                   !change.empty() ? change
                   : hint.empty()  ? "check the unit, the calibration and that the signal is breathing"
                                   : hint);
}

void check_samples(const Trace& trace, double median_period_s) {
  constexpr double fewest = 6;
  const double step_s =
      (trace.time_s.back() - trace.time_s.front()) / static_cast<double>(trace.time_s.size() - 1);
  if (median_period_s >= (fewest - 0.5) * step_s) return;
  throw InputError({trace.source},
                   "the median breath has " + number_text(median_period_s / step_s, 2) + " samples",
                   "6 or more, which show its top and its rest", "record more samples a second");
}

}  // namespace trunk
