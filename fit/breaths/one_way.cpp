#include "breaths/one_way.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "breaths/median_of.hpp"
#include "breaths/robust.hpp"
#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr double wide_step_s = 0.1, least_return = 1.0 / 3, most_drift = 1.25;
constexpr std::size_t fewest_steps = 10;
constexpr double still = 0.05, small_offset = 0.15;                         // of the strong steps
constexpr double short_rest = 0.25, long_rest = 0.45, levelled_from = 0.4;  // of all steps
constexpr double strong_step = 0.9, lowest_part = 0.003, some_return = 0.05;
constexpr double abrupt_s = 0.12, long_breath_s = 2, nearly_empty = 0.1, nearly_full = 0.9;

using Samples = std::span<const double>;

// What the mean of a volume moves from step to step.
struct WideSteps {
  std::vector<double> begin_s, moved;
};

WideSteps wide_steps(Samples time, Samples volume) {
  WideSteps steps;
  double before = 0;
  for (std::size_t begin = 0, i = 1; i < time.size(); ++i) {
    if (time[i] - time[begin] < wide_step_s) continue;
    double mean = 0;
    for (std::size_t k = begin; k < i; ++k) mean += volume[k] / static_cast<double>(i - begin);
    if (begin > 0) {
      steps.begin_s.push_back(time[begin]);
      steps.moved.push_back(mean - before);
    }
    before = mean;
    begin = i;
  }
  return steps;
}

// What a volume rises and falls in all, and by how much more it rises.
struct Way {
  double rise = 0, fall = 0;
  double net() const { return rise - fall; }
  double returned() const { return std::min(rise, fall) / std::max(rise, fall); }
};

// Returns the median way of the breaths that begin at some times, so that no artefact decides.
Way usual_way(const WideSteps& steps, const std::vector<double>& begin_s) {
  std::vector<Way> ways(begin_s.size());
  std::size_t breath = 0;
  for (std::size_t i = 0; i < steps.moved.size(); ++i) {
    while (breath + 1 < begin_s.size() && steps.begin_s[i] >= begin_s[breath + 1]) ++breath;
    (steps.moved[i] > 0 ? ways[breath].rise : ways[breath].fall) += std::abs(steps.moved[i]);
  }
  const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
  const auto signed_return = [](const Way& way) { return way.net() / (way.rise + way.fall); };
  std::nth_element(ways.begin(), middle, ways.end(),
                   [&](const Way& a, const Way& b) { return signed_return(a) < signed_return(b); });
  return *middle;
}

// The narrowest range that holds a share of all values.
struct Narrowest {
  double middle, width;
};

Narrowest narrowest(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::size_t first = 0;
  for (std::size_t i = 1; i + count < values.size(); ++i)
    if (values[i + count] - values[i] < values[first + count] - values[first]) first = i;
  return {0.5 * (values[first] + values[first + count]), values[first + count] - values[first]};
}

double strong_of(const std::vector<double>& moved) {
  std::vector<double> sizes;
  for (const double m : moved) sizes.push_back(std::abs(m));
  return quantile(std::move(sizes), strong_step);
}

// Returns whether a volume rests for a share of the time, apart from a small offset of its flow.
bool rests(const std::vector<double>& moved, double share) {
  const double strong = strong_of(moved);
  const Narrowest usual = narrowest(moved, share);
  return usual.width <= 2 * still * strong && std::abs(usual.middle) <= small_offset * strong;
}

std::string look_of_flow(const WideSteps& steps, Samples flow, const Way& way) {
  if (rests(steps.moved, long_rest))
    return "it rests at zero in between, as if only one direction were recorded";
  std::vector<double> forward;
  for (const double q : flow) forward.push_back(way.net() > 0 ? q : -q);
  const double zero = 2 * still * quantile(forward, strong_step);
  if (way.returned() > some_return || quantile(forward, lowest_part) > zero)
    return "it is shifted away from zero, as with an offset of the sensor";
  return rests(steps.moved, short_rest)
             ? "it rests at zero in between, as if its sign were lost or only one direction were recorded"
             : "it comes back to zero and turns there, as if its sign were lost";
}

// Returns a doubt if a volume moves at one rate for so long that a counter, or a flow of one direction, may
// have been levelled.
std::string levelled(const WideSteps& steps) {
  const double strong = strong_of(steps.moved);
  const Narrowest usual = narrowest(steps.moved, levelled_from);
  if (usual.width > 2 * still * strong || std::abs(usual.middle) <= small_offset * strong) return "";
  return fmt::format(
      "the volume {} at one rate for {:.0f} % of the time or more, as if a counter or a flow of one "
      "direction "
      "had been levelled: are both directions recorded?",
      usual.middle > 0 ? "rises" : "falls", percent_per_one * levelled_from);
}

InputError one_way(const Trace& trace, const WideSteps& steps, Samples flow, const Way& way) {
  const bool up = way.net() > 0;
  const double part = percent_per_one * way.returned();
  if (trace.kind == SignalKind::flow)
    return {{trace.source},
            fmt::format("the flow goes one way: {} adds up to {:.0f} % of {}; {}",
                        up ? "what is expired" : "what is inspired", part,
                        up ? "what is inspired" : "what is expired", look_of_flow(steps, flow, way)),
            "a flow that is positive on inspiration and negative on expiration",
            "export the flow with its sign, or a volume that rises and falls; if the sensor has an offset, "
            "--remove-drift takes it away"};
  const bool counts = rests(steps.moved, short_rest);
  return {{trace.source},
          fmt::format("the {} {} and hardly comes back: it {} by {:.0f} % of that; {}",
                      trace.kind == SignalKind::belt ? "belt" : "volume", up ? "rises" : "falls",
                      up ? "falls" : "rises", part,
                      counts ? "it rests in between, as a counter of one direction does"
                             : "it drifts by the size of a breath"),
          "a volume that rises with inspiration and falls with expiration",
          "export the flow, or a volume that counts both directions; if it is a drift, --remove-drift takes "
          "it away"};
}

// Returns how long the volume takes between 10 and 90 % before a breath's peak, or after it.
double course_s(const Segmentation& s, const Breath& b, bool rise) {
  const auto at = [&](double time) {
    return static_cast<std::size_t>(std::lower_bound(s.time_s.begin(), s.time_s.end(), time) -
                                    s.time_s.begin());
  };
  const auto share = [&](std::size_t i) { return s.volume_m3[i] / b.tidal_volume_m3; };
  const std::size_t first = at(b.onset_s), last = std::min(at(b.end_s), s.time_s.size() - 1),
                    peak = std::min(at(b.peak_s), last);
  // The samples between the last low or high one and the first of the other kind; crossings are linear.
  const auto cross = [&](std::size_t i, double level) {
    const double change = share(i) - share(i - 1);
    const double part = change == 0 ? 1 : std::clamp((level - share(i - 1)) / change, 0.0, 1.0);
    return s.time_s[i - 1] + part * (s.time_s[i] - s.time_s[i - 1]);
  };
  if (rise) {
    std::size_t until = first + 1;
    while (until < peak && share(until) < nearly_full) ++until;
    std::size_t from = until;
    while (from > first + 1 && share(from - 1) > nearly_empty) --from;
    return cross(until, nearly_full) - cross(from, nearly_empty);
  }
  std::size_t until = std::max<std::size_t>(peak, 1);
  while (until < last && share(until) > nearly_empty) ++until;
  std::size_t from = until;
  while (from > peak + 1 && share(from - 1) < nearly_full) --from;
  return cross(until, nearly_empty) - cross(from, nearly_full);
}

}  // namespace

void check_both_ways(const Trace& trace, const WholeBreaths& breaths, VolumeSignal& signal) {
  if (breaths.peak.empty()) return;
  const std::size_t first = breaths.trough.front(), count = breaths.trough.back() - first + 1;
  const auto part = [&](const std::vector<double>& all) { return Samples(all).subspan(first, count); };
  const WideSteps steps = wide_steps(part(signal.time_s), part(signal.volume));
  if (steps.moved.size() < fewest_steps) return;
  std::vector<double> begin_s;
  for (std::size_t i = 0; i < breaths.peak.size(); ++i) begin_s.push_back(signal.time_s[breaths.trough[i]]);
  const Way way = usual_way(steps, begin_s);
  if (way.returned() >= least_return && std::abs(way.net()) < most_drift * breaths.height) {
    if (std::string doubt = levelled(steps); !doubt.empty()) signal.notes.push_back(std::move(doubt));
    return;
  }
  const InputError error = one_way(trace, steps, part(trace.value), way);
  if (!trace.drift_by_user) throw error;
  signal.notes.push_back("--remove-drift takes away a drift as large as a breath, though " +
                         error.mistake().found);
}

void check_not_abrupt(const Segmentation& s) {
  const double period = median_of(s.breaths, [](const Breath& b) { return b.duration_s(); });
  const double limit = abrupt_s * std::min(period / long_breath_s, 1.0);
  for (const bool rise : {true, false}) {
    const double found = median_of(s.breaths, [&](const Breath& b) { return course_s(s, b, rise); });
    if (found >= limit) continue;
    throw InputError(
        {s.source},
        fmt::format("the median breath {} from {} % within {} s", rise ? "fills" : "empties",
                    rise ? "10 to 90" : "90 to 10", number_text(found, 2)),
        "a breath, which takes longer",
        "give a volume without resets, or the flow; a gas analyser or a counter jumps like this");
  }
}

}  // namespace trunk
