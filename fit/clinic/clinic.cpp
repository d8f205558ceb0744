#include "clinic/clinic.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "clinic/lung_mechanics.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using Curve = std::vector<double>;

/// What measures of one breath share.
struct Case {
  const BreathLoop& loop;
  const ClinicOptions& options;

  bool pleural() const { return !loop.pleural_Pa.empty(); }
  bool across() const { return !loop.transdiaphragmatic_Pa.empty(); }
  double litres() const { return litres_per_m3 * loop.tidal_volume_m3(); }
  double per_minute() const { return s_per_min / loop.duration_s; }

  /// Returns the fall of pleural pressure before flow begins: intrinsic PEEP, positive.
  double intrinsic_peep_Pa() const { return 0 - change_before_flow(loop, loop.pleural_Pa, -1); }

  /// The work on the lung in inspiration: the area left of the pressure at end-expiration.
  double lung_work_J() const { return -over_inspired_volume(loop, loop.pleural_Pa); }
  /// Its elastic part: the triangle below the line between the two points without flow.
  double elastic_work_J() const {
    return -0.5 * at_end_inspiration(loop, loop.pleural_Pa) * loop.tidal_volume_m3();
  }
  double peep_work_J() const { return intrinsic_peep_Pa() * loop.tidal_volume_m3(); }
  double chest_wall_work_J() const {
    const auto& compliance = options.chest_wall_compliance_m3_Pa;
    return compliance ? 0.5 * loop.tidal_volume_m3() * loop.tidal_volume_m3() / *compliance : 0;
  }
  double work_J() const { return lung_work_J() + peep_work_J() + chest_wall_work_J(); }

  /// Returns pleural pressure less the line between its two points without flow.
  Curve off_the_line() const {
    const double slope = at_end_inspiration(loop, loop.pleural_Pa) / loop.tidal_volume_m3();
    Curve curve;
    for (std::size_t i = 0; i < loop.time_s.size(); ++i)
      curve.push_back(loop.pleural_Pa[i] - slope * loop.volume_m3[i]);
    return curve;
  }

  double pleural_product_Pa_s() const {
    const auto& compliance = options.chest_wall_compliance_m3_Pa;
    const double wall = compliance ? over_inspiration(loop, loop.volume_m3) / *compliance : 0;
    return wall + intrinsic_peep_Pa() * loop.inspiration_s - over_inspiration(loop, loop.pleural_Pa);
  }
  double across_product_Pa_s() const {
    const double before = change_before_flow(loop, loop.transdiaphragmatic_Pa, 1);
    return before * loop.inspiration_s + over_inspiration(loop, loop.transdiaphragmatic_Pa);
  }
};

// Returns the largest change in inspiration, with its sign.
double swing(const BreathLoop& loop, const Curve& pressure) {
  double most = at_end_inspiration(loop, pressure);
  for (std::size_t i = 0; i < pressure.size() && loop.time_s[i] <= loop.inspiration_s; ++i)
    if (std::abs(pressure[i]) > std::abs(most)) most = pressure[i];
  return most;
}

double cmH2O(double Pa) {
  return Pa / Pa_per_cmH2O;
}

double compliance_ml_per_cmH2O(const Case& c) {
  const double pressure = at_end_inspiration(c.loop, c.loop.transpulmonary_Pa());
  return pressure > 0 ? ml_per_m3 * c.loop.tidal_volume_m3() / cmH2O(pressure) : unknown;
}

struct Measure {
  const char *name, *unit, *meaning;
  bool (*known)(const Case&);
  double (*value)(const Case&);
};

bool has_pleural(const Case& c) {
  return c.pleural();
}
bool has_across(const Case& c) {
  return c.across();
}

// Work: Campbell's diagram (ATS/ERS, Am J Respir Crit Care Med 2002;166:518, and Cabello and Mancebo,
// Intensive Care Med 2006;32:1311). Pressure-time products: Sassoon et al., Am Rev Respir Dis 1991;143:469.
// Tension-time index: Bellemare and Grassino, J Appl Physiol 1982;53:1190. Intrinsic PEEP: Petrof et al., Am
// Rev Respir Dis 1990;141:281.
const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = {
      {"pleural_swing_cmH2O", "cmH2O", "largest change of pleural pressure in inspiration", has_pleural,
       [](const Case& c) { return cmH2O(swing(c.loop, c.loop.pleural_Pa)); }},
      {"gastric_swing_cmH2O", "cmH2O", "largest change of gastric pressure in inspiration",
       [](const Case& c) { return !c.loop.gastric_Pa.empty(); },
       [](const Case& c) { return cmH2O(swing(c.loop, c.loop.gastric_Pa)); }},
      {"transdiaphragmatic_swing_cmH2O", "cmH2O",
       "largest change of transdiaphragmatic pressure in inspiration", has_across,
       [](const Case& c) { return cmH2O(swing(c.loop, c.loop.transdiaphragmatic_Pa)); }},
      {"work_of_breathing_J_per_L", "J/L", "inspiratory work over tidal volume", has_pleural,
       [](const Case& c) { return c.work_J() / c.litres(); }},
      {"work_of_breathing_J_per_min", "J/min", "inspiratory work a minute", has_pleural,
       [](const Case& c) { return c.work_J() * c.per_minute(); }},
      {"elastic_work_J_per_L", "J/L", "part of the inspiratory work: the lung's recoil", has_pleural,
       [](const Case& c) { return c.elastic_work_J() / c.litres(); }},
      {"resistive_work_J_per_L", "J/L", "part of the inspiratory work: airway and lung tissue", has_pleural,
       [](const Case& c) { return (c.lung_work_J() - c.elastic_work_J()) / c.litres(); }},
      {"intrinsic_peep_work_J_per_L", "J/L", "part of the inspiratory work: intrinsic PEEP", has_pleural,
       [](const Case& c) { return c.peep_work_J() / c.litres(); }},
      {"chest_wall_work_J_per_L", "J/L", "part of the inspiratory work: the passive chest wall",
       [](const Case& c) { return c.pleural() && c.options.chest_wall_compliance_m3_Pa; },
       [](const Case& c) { return c.chest_wall_work_J() / c.litres(); }},
      {"expiratory_resistive_work_J_per_L", "J/L",
       "expiratory work on airway and lung tissue, whoever does it", has_pleural,
       [](const Case& c) { return over_expired_volume(c.loop, c.off_the_line()) / c.litres(); }},
      {"pressure_time_product_pleural_cmH2O_s", "cmH2O s",
       "pressure-time product of pleural pressure a breath", has_pleural,
       [](const Case& c) { return cmH2O(c.pleural_product_Pa_s()); }},
      {"pressure_time_product_pleural_cmH2O_s_per_min", "cmH2O s/min",
       "pressure-time product of pleural pressure a minute", has_pleural,
       [](const Case& c) { return cmH2O(c.pleural_product_Pa_s()) * c.per_minute(); }},
      {"pressure_time_product_transdiaphragmatic_cmH2O_s", "cmH2O s",
       "pressure-time product of transdiaphragmatic pressure a breath", has_across,
       [](const Case& c) { return cmH2O(c.across_product_Pa_s()); }},
      {"pressure_time_product_transdiaphragmatic_cmH2O_s_per_min", "cmH2O s/min",
       "pressure-time product of transdiaphragmatic pressure a minute", has_across,
       [](const Case& c) { return cmH2O(c.across_product_Pa_s()) * c.per_minute(); }},
      {"tension_time_index", "1", "mean Pdi over its maximum, times Ti over Ttot",
       [](const Case& c) { return c.across() && c.options.pdi_max_Pa; },
       [](const Case& c) { return c.across_product_Pa_s() / c.loop.duration_s / *c.options.pdi_max_Pa; }},
      {"tension_time_cmH2O", "cmH2O", "mean Pdi times Ti over Ttot, not divided by the maximum",
       [](const Case& c) { return c.across() && !c.options.pdi_max_Pa; },
       [](const Case& c) { return cmH2O(c.across_product_Pa_s()) / c.loop.duration_s; }},
      {"dynamic_lung_compliance_ml_per_cmH2O", "ml/cmH2O",
       "tidal volume over the pressure between both points "
       "without flow",
       has_pleural, compliance_ml_per_cmH2O},
      {"dynamic_lung_elastance_cmH2O_per_L", "cmH2O/L", "of the lung, by regression", has_pleural,
       [](const Case& c) { return cmH2O(lung_mechanics(c.loop).elastance) * m3_per_litre; }},
      {"lung_resistance_cmH2O_s_per_L", "cmH2O s/L", "of airway and lung tissue, by regression", has_pleural,
       [](const Case& c) { return cmH2O(lung_mechanics(c.loop).resistance) * m3_per_litre; }},
      {"intrinsic_peep_cmH2O", "cmH2O", "fall of pleural pressure before inspiratory flow begins",
       has_pleural, [](const Case& c) { return cmH2O(c.intrinsic_peep_Pa()); }}};
  return all;
}

// => mean, lower95, upper95
void summarise(ClinicNumber& number) {
  Curve known;
  std::copy_if(number.each.begin(), number.each.end(), std::back_inserter(known),
               [](double v) { return std::isfinite(v); });
  const auto n = static_cast<double>(known.size());
  double squares = 0;
  number.mean = 0;
  for (const double v : known) number.mean += v / n;
  for (const double v : known) squares += (v - number.mean) * (v - number.mean);
  const double half =
      known.size() > 1 ? gsl_cdf_tdist_Pinv(0.975, n - 1) * std::sqrt(squares / (n * (n - 1))) : INFINITY;
  number.lower95 = number.mean - half, number.upper95 = number.mean + half;
}

// Doubts what hangs on the phase between flow and pleural pressure, where that phase cannot be right.
// => doubt
void doubt_phase(std::vector<ClinicNumber>& numbers) {
  constexpr double least_resistance = 0.2;  // cmH2O s/L
  static constexpr std::array of_phase = {"resistive_work_J_per_L", "expiratory_resistive_work_J_per_L",
                                          "lung_resistance_cmH2O_s_per_L"};
  const auto resistance = std::find_if(numbers.begin(), numbers.end(), [](const ClinicNumber& n) {
    return n.name == "lung_resistance_cmH2O_s_per_L";
  });
  if (resistance == numbers.end() || resistance->mean >= least_resistance) return;
  for (ClinicNumber& n : numbers)
    if (std::find(of_phase.begin(), of_phase.end(), n.name) != of_phase.end())
      n.doubt =
          "the lung resistance is less than any airway has: flow and pleural pressure may be out of step";
}

}  // namespace

std::vector<ClinicNumber> clinic_numbers(const MeasuredBreath& breath, const ClinicOptions& options) {
  const auto value_of = [&](const Measure& measure, const BreathLoop& loop) {
    const Case one{loop, options};
    return measure.known(one) ? measure.value(one) : unknown;
  };
  const BreathLoop mean = mean_loop(breath);
  std::vector<BreathLoop> loops;
  for (std::size_t b = 0; b < breath.used.size(); ++b) loops.push_back(loop_of(breath, b));
  std::vector<ClinicNumber> numbers;
  for (const Measure& measure : measures()) {
    ClinicNumber number{measure.name, measure.unit, measure.meaning, {}, 0, 0, 0, value_of(measure, mean)};
    for (const BreathLoop& loop : loops) number.each.push_back(value_of(measure, loop));
    if (std::none_of(number.each.begin(), number.each.end(), [](double v) { return std::isfinite(v); }))
      continue;
    summarise(number);
    numbers.push_back(std::move(number));
  }
  doubt_phase(numbers);
  return numbers;
}

}  // namespace trunk
