#include "gates/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/units.hpp"

namespace trunk {
namespace {

constexpr double machine_rise_s = 0.10, quick_rise_s = 0.17, machine_fall_s = 0.095, long_breath_s = 2;
constexpr double least_size = 0.02, largest_size = 0.8, adult_m3 = 1.5e-3;
constexpr double most_wander = 0.5;
constexpr double least_mismatch = 0.02, offset_from = 0.3, no_return = 1.5;
constexpr double normal_quantile = 1.96;
constexpr std::size_t few_breaths = 3;
constexpr double few_samples = 10, deep_m3 = 2e-3;

double percent(double share) {
  return percent_per_one * share;
}

std::optional<Gate> upside_down(const TraceSigns& s) {
  if (s.orientation.upright != Upright::no) return std::nullopt;
  return Gate{"upside_down",
              "the recording looks upside down: it rests near its highest values, but lungs rest near their "
              "lowest; if it is positive on expiration, use --invert"};
}

std::optional<Gate> machine_driven(const TraceSigns& s) {
  const FlowSigns& flow = s.orientation.flow;
  const double scale = std::min(flow.period_s / long_breath_s, 1.0);
  const auto within = [&](double time_s, double limit_s) { return time_s > 0 && time_s < limit_s * scale; };
  if (!within(flow.rise_s, machine_rise_s) &&
      !(within(flow.rise_s, quick_rise_s) && within(flow.fall_s, machine_fall_s)))
    return std::nullopt;
  return Gate{
      "machine_driven",
      fmt::format("not driven by a muscle? the inspiratory flow is there within {:.0f} ms{}, as when a "
                  "ventilator gives the breaths; give a recording of spontaneous breathing",
                  ms_per_s * flow.rise_s,
                  flow.fall_s > 0
                      ? fmt::format(" and the expiratory flow within {:.0f} ms", ms_per_s * flow.fall_s)
                      : "")};
}

std::optional<Gate> wander(const TraceSigns& s) {
  if (s.wander <= most_wander) return std::nullopt;
  return Gate{"wander",
              fmt::format("the end-expiratory level strays by {:.0f} % of a tidal volume from breath "
                          "to breath; choose a quieter part, or leave breaths out with --exclude",
                          percent(s.wander))};
}

std::optional<Gate> not_a_breathing_signal(const TraceSigns& s) {
  if (std::abs(s.gain_mismatch) <= no_return) return std::nullopt;
  return Gate{"not_a_breathing_signal",
              fmt::format("what is {} does not return: the flow may have lost its sign, or the volume counts "
                          "up; give a flow with its sign, or a volume that rises and falls",
                          s.gain_mismatch > 0 ? "inspired" : "expired")};
}

std::optional<Gate> gain_mismatch(const TraceSigns& s) {
  const double d = std::abs(s.gain_mismatch);
  if (d < offset_from || d > no_return || !s.mismatch_by_size) return std::nullopt;
  return Gate{
      "gain_mismatch",
      fmt::format("in- and expired volumes differ by {:.0f} %, and the more the deeper a breath is: the "
                  "flowmeter reads one direction too high; calibrate both directions",
                  percent(d))};
}

// Returns the relative standard error of the tidal volume.
double error_of_mismatch(const TraceSigns& s) {
  const double size = std::abs(s.gain_mismatch);
  if (size <= least_mismatch || size >= offset_from || s.mismatch_by_duration) return 0;
  return size * std::max(s.inspired_part, 1 - s.inspired_part) / normal_quantile;
}

void add_doubts(const TraceSigns& s, bool size_known, std::vector<std::string>& notes) {
  if (s.orientation.upright == Upright::unclear)
    notes.push_back(
        "the shape of the breaths does not show which way is up: check that the signal rises on inspiration, "
        "else use --invert");
  const double d = std::abs(s.gain_mismatch);
  if (const double error = error_of_mismatch(s); error > 0)
    notes.push_back(fmt::format(
        "in- and expired volumes differ by {:.1f} %, so that the tidal volume is known to {:.1f} %: "
        "the flowmeter may read one direction too high",
        percent(d), percent(normal_quantile * error)));
  if (d >= offset_from && d <= no_return && !s.mismatch_by_size)
    notes.push_back(fmt::format(
        "in- and expired volumes differ by {:.0f} % of a breath: the flow has an offset, or air leaks; "
        "it is removed breath by breath",
        percent(d)));
  if (s.breaths < few_breaths)
    notes.push_back(
        fmt::format("{} breath(s) used: so few do not show the spread from breath to breath", s.breaths));
  if (s.inspiration_s < few_samples * s.step_s)
    notes.push_back(
        fmt::format("{:.1f} samples per inspiration are too few for its timing", s.inspiration_s / s.step_s));
  if (size_known && s.tidal_volume_m3 > deep_m3)
    notes.push_back(
        fmt::format("a tidal volume of {:.0f} ml is beyond what the model was made for (quiet breathing "
                    "and exercise up to 2000 ml)",
                    ml_per_m3 * s.tidal_volume_m3));
}

}  // namespace

std::optional<Gate> subject_size(double tidal_volume_m3, double end_expiratory_m3) {
  const double share = tidal_volume_m3 / end_expiratory_m3;
  if (share >= least_size && share <= largest_size) return std::nullopt;
  return Gate{
      "subject_size",
      fmt::format("a tidal volume of {:.0f} ml is {:.2g} % of the end-expiratory volume: this trunk is "
                  "{} of {:.0f} ml; give a trunk of the subject's size, or check the unit",
                  ml_per_m3 * tidal_volume_m3, percent(share),
                  end_expiratory_m3 > adult_m3 ? "an adult's" : "one", ml_per_m3 * end_expiratory_m3)};
}

Screening screened(const TraceSigns& signs, std::optional<double> end_expiratory_m3) {
  Screening screening;
  for (auto gate :
       {upside_down(signs), machine_driven(signs),
        end_expiratory_m3 ? subject_size(signs.tidal_volume_m3, *end_expiratory_m3) : std::nullopt,
        gain_mismatch(signs), wander(signs), not_a_breathing_signal(signs)})
    if (gate) screening.gates.push_back(std::move(*gate));
  screening.tidal_volume_error = error_of_mismatch(signs);
  add_doubts(signs, end_expiratory_m3.has_value(), screening.notes);
  return screening;
}

Screening screened(const Segmentation& segmentation, std::optional<double> end_expiratory_m3) {
  return screened(trace_signs(segmentation), end_expiratory_m3);
}

}  // namespace trunk
