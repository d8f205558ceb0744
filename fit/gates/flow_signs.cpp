#include "gates/flow_signs.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/median_of.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_breaths = 60, enough_for_error = 3;
constexpr double step_s = 0.005, least_width_s = 0.02, widest_s = 0.15, widening = 1.4;
constexpr double longest_sample_s = 0.1;
constexpr double good_error = 0.03, largest_error = 0.06;  // of the peak flow
constexpr double low = 0.1, high = 0.9;                    // of the peak flow: begin and end of its rise
constexpr double margin_s = 0.5;                           // before the alignment: a rise may begin there
constexpr double rise_of_width = 0.8;                      // from 10 to 90 % of a mean over a width

// A flow towards one side, over tidal volumes, at times step_s apart from margin_s before the alignment on.
struct MeanFlow {
  std::vector<double> flow, error;  // [samples] error: standard error of the mean

  double peak() const { return *std::max_element(flow.begin(), flow.end()); }
  double relative_error() const { return median(error) / peak(); }
};

// How the flow of one phase is found: where it begins, its sign and how long it lasts.
struct Phase {
  double Breath::*begin_s;
  double sign, duration_s;
};

MeanFlow mean_flow(const Segmentation& s, const std::vector<Breath>& breaths, const Phase& phase,
                   double width_s) {
  MeanFlow mean;
  const auto n = static_cast<double>(breaths.size());
  const auto samples = static_cast<std::size_t>((margin_s + phase.duration_s) / step_s) + 1;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * step_s - margin_s;
    double sum = 0, squares = 0;
    for (const Breath& b : breaths) {
      const double at = b.*phase.begin_s + t;
      const double change = interpolated(s.time_s, s.volume_m3, at + 0.5 * width_s) -
                            interpolated(s.time_s, s.volume_m3, at - 0.5 * width_s);
      const double flow = phase.sign * change / (width_s * b.tidal_volume_m3);
      sum += flow, squares += flow * flow;
    }
    mean.flow.push_back(sum / n);
    mean.error.push_back(breaths.size() < enough_for_error
                             ? 0
                             : std::sqrt(std::max(squares - sum * sum / n, 0.0) / (n * (n - 1))));
  }
  return mean;
}

// Returns the time from 10 to 90 % of the peak, or 0 if the flow does not begin below 10 %.
double rise_of(const MeanFlow& mean) {
  const double peak = mean.peak();
  const std::vector<double>& flow = mean.flow;
  const auto crossing = [&](std::size_t i, double level) {  // between samples i-1 and i
    return static_cast<double>(i) - (flow[i] - level) / (flow[i] - flow[i - 1]);
  };
  // The mean also holds the end of the phase before, so the rise is sought backwards from the top.
  const auto top = static_cast<std::size_t>(std::max_element(flow.begin(), flow.end()) - flow.begin());
  std::size_t lower = top;
  while (lower > 0 && flow[lower - 1] > low * peak) --lower;
  if (lower == 0) return 0;
  std::size_t upper = lower;
  while (flow[upper] < high * peak) ++upper;
  return step_s * (crossing(upper, high * peak) - crossing(lower, low * peak));
}

double rise_s(const Segmentation& s, const std::vector<Breath>& breaths, const Phase& phase) {
  const double sample_s = (s.time_s.back() - s.time_s.front()) / static_cast<double>(s.time_s.size() - 1);
  if (sample_s > longest_sample_s) return 0;
  double width_s = std::max(sample_s, least_width_s);
  MeanFlow mean = mean_flow(s, breaths, phase, width_s);
  while (mean.relative_error() > good_error && widening * width_s <= widest_s) {
    width_s *= widening;
    mean = mean_flow(s, breaths, phase, width_s);
  }
  if (mean.peak() <= 0 || mean.relative_error() > largest_error) return 0;
  const double found = rise_of(mean), blur = rise_of_width * width_s;
  return found > 0 ? std::max(std::sqrt(std::max(found * found - blur * blur, 0.0)), 0.5 * width_s) : 0;
}

// Returns up to most_breaths of them, spread evenly.
std::vector<Breath> some_of(const std::vector<Breath>& breaths) {
  if (breaths.size() <= most_breaths) return breaths;
  std::vector<Breath> some;
  for (std::size_t i = 0; i < most_breaths; ++i) some.push_back(breaths[i * breaths.size() / most_breaths]);
  return some;
}

}  // namespace

FlowSigns flow_signs(const Segmentation& segmentation, const std::vector<Breath>& breaths) {
  const std::vector<Breath> some = some_of(breaths);
  const double in_s = median_of(some, [](const Breath& b) { return b.inspiration_s(); });
  const double out_s = median_of(some, [](const Breath& b) { return b.expiration_s(); });
  return {rise_s(segmentation, some, {&Breath::onset_s, 1, in_s}),
          rise_s(segmentation, some, {&Breath::peak_s, -1, out_s}),
          median_of(some, [](const Breath& b) { return b.duration_s(); })};
}

}  // namespace trunk
