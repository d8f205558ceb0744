#include "breaths/segment.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/landmarks.hpp"
#include "breaths/plausibility.hpp"
#include "breaths/robust.hpp"
#include "breaths/volume_signal.hpp"
#include "breaths/whole_breaths.hpp"
#include "errors/input_error.hpp"
#include "io/message_text.hpp"

namespace trunk {
namespace {

std::string ml(double volume_m3) {
  return number_text(volume_m3 * 1e6, 3) + " ml";
}
std::string seconds(double time_s) {
  return number_text(time_s, 3) + " s";
}

void check_any(const Trace& trace, const WholeBreaths& found) {
  if (!found.peak.empty()) return;
  throw InputError(trace.source, 0,
                   "no whole breath in " + seconds(trace.time_s.back() - trace.time_s.front()) + " (" +
                       std::to_string(found.inspirations) +
                       " inspiration(s) seen); expected at least one breath from rest to rest; give a longer "
                       "recording, or "
                       "one that begins and ends at the end of an expiration");
}

std::vector<Breath> breaths_at(const Landmarks& marks) {
  std::vector<Breath> breaths;
  for (std::size_t i = 0; i < marks.peak_s.size(); ++i)
    breaths.push_back(
        {marks.rest.time[i], marks.peak_s[i], marks.rest.time[i + 1], marks.tidal_volume[i], true, ""});
  return breaths;
}

template <class Measure>
double median_of(const std::vector<Breath>& breaths, Measure measure) {
  std::vector<double> values;
  for (const auto& breath : breaths) values.push_back(measure(breath));
  return median(std::move(values));
}

double duration(const Breath& breath) {
  return breath.end_s - breath.onset_s;
}
double tidal_volume(const Breath& breath) {
  return breath.tidal_volume_m3;
}
double inspired_part(const Breath& breath) {
  return (breath.peak_s - breath.onset_s) / duration(breath);
}

std::string far_from_median(const std::string& what, double value, double usual,
                            std::string (*text)(double)) {
  if (value < 0.5 * usual) return what + " " + text(value) + " is under half the median " + text(usual);
  if (value > 2 * usual) return what + " " + text(value) + " is over twice the median " + text(usual);
  return "";
}

std::string odd_inspiration(const Breath& breath) {
  const double part = inspired_part(breath);
  if (part >= 0.1 && part <= 0.9) return "";
  return "inspiration takes " + number_text(100 * part, 2) + " % of the breath";
}

std::string odd_return(const Breath& breath, double difference_m3) {
  if (std::abs(difference_m3) <= 0.5 * breath.tidal_volume_m3) return "";
  return "ends " + ml(std::abs(difference_m3)) + (difference_m3 > 0 ? " above" : " below") +
         " where it began, over half of its tidal volume " + ml(breath.tidal_volume_m3);
}

// How far the rest moved over breath i, beyond what it does in the median or over the breath before or after:
// a wander of the base line moves several alike, a shift one.
double sudden_change(const Landmarks& marks, std::size_t i, double drift) {
  const auto& [time, value] = marks.rest;
  const auto slope = [&](std::size_t k) { return (value[k + 1] - value[k]) / (time[k + 1] - time[k]); };
  double sudden = slope(i) - drift;
  const auto compare = [&](double other) {
    if (std::abs(slope(i) - other) < std::abs(sudden)) sudden = slope(i) - other;
  };
  if (i > 0) compare(slope(i - 1));
  if (i + 2 < time.size()) compare(slope(i + 1));
  return sudden * (time[i + 1] - time[i]);
}

void judge(std::vector<Breath>& breaths, const Landmarks& marks, double drift) {
  const double usual_volume = median_of(breaths, tidal_volume), usual_duration = median_of(breaths, duration);
  for (std::size_t i = 0; i < breaths.size(); ++i) {
    Breath& breath = breaths[i];
    const double change = sudden_change(marks, i, drift);
    for (const auto& reason : {far_from_median("tidal volume", breath.tidal_volume_m3, usual_volume, ml),
                               far_from_median("duration", duration(breath), usual_duration, seconds),
                               odd_inspiration(breath), odd_return(breath, change)}) {
      if (reason.empty()) continue;
      breath.kept = false;
      breath.reason += (breath.reason.empty() ? "" : "; ") + reason;
    }
  }
}

void check_any_kept(const Trace& trace, const std::vector<Breath>& breaths) {
  if (std::any_of(breaths.begin(), breaths.end(), [](const Breath& breath) { return breath.kept; })) return;
  throw InputError(trace.source, 0,
                   "none of the " + std::to_string(breaths.size()) +
                       " whole breaths can be used, the first because " + breaths.front().reason +
                       "; expected quiet, even breathing; give another recording");
}

void subtract_baseline(VolumeSignal& signal, const KnotLine& rest, double drift) {
  for (std::size_t i = 0; i < signal.time_s.size(); ++i) signal.volume_m3[i] -= rest(signal.time_s[i], drift);
}

/// Lungs rest empty: a signal that spends clearly more time above three quarters of its breaths than below
/// one quarter is probably upside down (our choice: half as much again).
bool rests_full(const Segmentation& s) {
  double low = 0, high = 0;
  for (const Breath& b : s.breaths)
    for (std::size_t i = 0; i < s.time_s.size(); ++i)
      if (s.time_s[i] >= b.onset_s && s.time_s[i] < b.end_s) {
        low += s.volume_m3[i] < 0.25 * b.tidal_volume_m3 ? 1 : 0;
        high += s.volume_m3[i] > 0.75 * b.tidal_volume_m3 ? 1 : 0;
      }
  return high > 1.5 * low;
}

void add_notes(Segmentation& result, double drift) {
  const double period = median_of(result.breaths, duration);
  const double per_breath = drift * period, usual_volume = median_of(result.breaths, tidal_volume);
  if (std::abs(per_breath) > 0.01 * usual_volume)
    result.notes.push_back("a drift of " + ml(per_breath) + " a breath was removed");
  const double before = result.breaths.front().onset_s - result.time_s.front();
  const double after = result.time_s.back() - result.breaths.back().end_s;
  if (before > 0.05 * period || after > 0.05 * period)
    result.notes.push_back("not used: " + seconds(before) + " before the first and " + seconds(after) +
                           " after the last whole breath");
  if (rests_full(result))
    result.notes.push_back(
        "the signal rests near its highest values, as lungs do not: is it positive on expiration? Then use "
        "--invert");
}

}  // namespace

Segmentation segment_breaths(const Trace& trace) {
  VolumeSignal signal = volume_signal(trace);
  const WholeBreaths found = whole_breaths(signal.time_s, signal.volume_m3);
  check_any(trace, found);
  const Landmarks marks = landmarks(signal.time_s, signal.volume_m3, found);
  Segmentation result;
  result.breaths = breaths_at(marks);
  check_plausible(trace, median_of(result.breaths, duration), median_of(result.breaths, tidal_volume));
  judge(result.breaths, marks, found.drift);
  check_any_kept(trace, result.breaths);

  subtract_baseline(signal, marks.rest, found.drift);
  result.time_s = std::move(signal.time_s);
  result.volume_m3 = std::move(signal.volume_m3);
  result.sigma_m3 = trace.sigma_m3;
  result.source = trace.source;
  result.notes = trace.notes;
  result.notes.insert(result.notes.end(), signal.notes.begin(), signal.notes.end());
  add_notes(result, found.drift);
  return result;
}

}  // namespace trunk
