#include "gates/upside_down.hpp"

#include <gsl/gsl_statistics.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "errors/input_error.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double surely_upright = -0.5;
constexpr double upside_down_from = 0.16, unclear_from = -0.1, clear_errors = 2;
constexpr double abruptness_weight = 0.75, most_abruptness = 0.15;
constexpr double error_of_median = 1.2533;  // over that of a mean, normal distribution

// Returns the mean volume of a breath by trapezia over its samples.
double mean_volume(const Segmentation& s, const Breath& b) {
  const auto first = std::lower_bound(s.time_s.begin(), s.time_s.end(), b.onset_s) - s.time_s.begin();
  double area = 0, before_s = b.onset_s, before = interpolated(s.time_s, s.volume_m3, before_s);
  for (auto i = static_cast<std::size_t>(first); i < s.time_s.size() && s.time_s[i] <= b.end_s; ++i) {
    area += 0.5 * (before + s.volume_m3[i]) * (s.time_s[i] - before_s);
    before_s = s.time_s[i], before = s.volume_m3[i];
  }
  area += 0.5 * (before + interpolated(s.time_s, s.volume_m3, b.end_s)) * (b.end_s - before_s);
  return area / b.duration_s();
}

// Returns s of each breath.
std::vector<double> shapes(const Segmentation& segmentation, const std::vector<Breath>& breaths) {
  std::vector<double> all;
  for (const Breath& b : breaths)
    all.push_back(std::log(b.inspiration_s() / b.expiration_s()) +
                  4 * (mean_volume(segmentation, b) / b.tidal_volume_m3 - 0.5));
  return all;
}

// Returns the breaths of the signal turned upside down, if there are any.
std::optional<Segmentation> turned(const Segmentation& segmentation) {
  Trace trace;
  trace.source = segmentation.source;
  trace.kind = SignalKind::belt;  // its size has been checked
  trace.time_s = segmentation.time_s;
  for (const double v : segmentation.volume_m3) trace.value.push_back(-v);
  try {
    return segment_breaths(trace);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Upright upright_by(double index, double error) {
  if (index >= upside_down_from && index > clear_errors * error) return Upright::no;
  return index > unclear_from ? Upright::unclear : Upright::yes;
}

}  // namespace

std::vector<Breath> breaths_to_judge(const Segmentation& segmentation) {
  std::vector<Breath> kept;
  for (const Breath& b : segmentation.breaths)
    if (b.kept) kept.push_back(b);
  return kept.empty() ? segmentation.breaths : kept;
}

Orientation orientation(const Segmentation& segmentation, const std::vector<Breath>& breaths) {
  const std::vector<double> each = shapes(segmentation, breaths);
  Orientation result;
  result.index = median(each);
  result.flow = flow_signs(segmentation, breaths);
  if (each.size() > 1)
    result.standard_error = error_of_median * gsl_stats_sd(each.data(), 1, each.size()) /
                            std::sqrt(static_cast<double>(each.size()));
  if (result.index < surely_upright || segmentation.sign == SignShownBy::pressure) return result;
  const auto other = turned(segmentation);
  if (!other) {
    result.upright = Upright::unclear;
    return result;
  }
  const std::vector<Breath> other_breaths = breaths_to_judge(*other);
  result.index = 0.5 * (result.index - median(shapes(*other, other_breaths)));
  const FlowSigns& flow = result.flow;
  if (flow.rise_s > 0 && flow.fall_s > 0)
    result.index -= abruptness_weight *
                    std::clamp(std::log(flow.fall_s / flow.rise_s), -most_abruptness, most_abruptness);
  result.upright = upright_by(result.index, result.standard_error);
  if (result.upright == Upright::unclear && segmentation.sign == SignShownBy::volume)
    result.upright = Upright::yes;
  if (result.upright == Upright::no) result.flow = flow_signs(*other, other_breaths);
  return result;
}

}  // namespace trunk
