#include "breaths/segment.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/breath_text.hpp"
#include "breaths/doubts.hpp"
#include "breaths/heart_ripple.hpp"
#include "breaths/judge.hpp"
#include "breaths/landmarks.hpp"
#include "breaths/median_of.hpp"
#include "breaths/one_way.hpp"
#include "breaths/plausibility.hpp"
#include "breaths/volume_signal.hpp"
#include "breaths/whole_breaths.hpp"
#include "errors/input_error.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

void check_any(const Trace& trace, const WholeBreaths& found) {
  if (!found.peak.empty()) return;
  throw InputError({trace.source},
                   "no whole breath in " + seconds_text(trace.time_s.back() - trace.time_s.front()) + " (" +
                       std::to_string(found.inspirations) + " inspiration(s) seen)",
                   "at least one breath from rest to rest",
                   "give a longer recording, or one that begins and ends at the end of an expiration");
}

std::vector<Breath> breaths_at(const Landmarks& marks, std::size_t first_number) {
  std::vector<Breath> breaths;
  const std::vector<double>&time = marks.rest.time, &value = marks.rest.value;
  for (std::size_t i = 0; i < marks.peak_s.size(); ++i) {
    Breath b{time[i], marks.peak_s[i], time[i + 1], marks.tidal_volume[i], true, ""};
    b.number = first_number + i;
    b.pause_s = std::min(marks.rests_s[i + 1], b.expiration_s());
    b.inspired_m3 = b.tidal_volume_m3 + marks.rest(b.peak_s) - value[i];
    b.expired_m3 = b.tidal_volume_m3 + marks.rest(b.peak_s) - value[i + 1];
    breaths.push_back(b);
  }
  return breaths;
}

// Keeps the samples from first to last. => result
void keep_samples(std::size_t first, std::size_t last, Segmentation& result) {
  const auto cut = [&](std::vector<double>& all) {
    if (!all.empty())
      all = {all.begin() + static_cast<std::ptrdiff_t>(first),
             all.begin() + static_cast<std::ptrdiff_t>(last + 1)};
  };
  for (auto* all : {&result.time_s, &result.volume_m3, &result.sigma_m3}) cut(*all);
  for (TraceChannel& channel : result.channels) cut(channel.value);
}

std::vector<Breath> kept_of(const std::vector<Breath>& breaths) {
  std::vector<Breath> kept;
  for (const Breath& breath : breaths)
    if (breath.kept) kept.push_back(breath);
  return kept;
}

// Scales all volumes so that the median of the kept breaths (of all, if none is kept) is the given one. =>
// result
void calibrate(Segmentation& result, double tidal_volume_m3) {
  const std::vector<Breath> kept = kept_of(result.breaths);
  const double found = median_of(kept.empty() ? result.breaths : kept, tidal_volume_of);
  const double factor = tidal_volume_m3 / found;
  for (double& v : result.volume_m3) v *= factor;
  for (double& v : result.sigma_m3) v *= factor;
  for (double& v : result.rest.value) v *= factor;
  for (Breath& breath : result.breaths)
    for (double* v : {&breath.tidal_volume_m3, &breath.inspired_m3, &breath.expired_m3}) *v *= factor;
  result.notes.push_back("scaled so that the median tidal volume is " + volume_text(tidal_volume_m3, true) +
                         (result.calibrated ? ", which was " + volume_text(found, true) : ""));
  result.calibrated = true;
}

void subtract_baseline(const KnotLine& rest, double drift, Segmentation& result) {
  for (std::size_t i = 0; i < result.time_s.size(); ++i) result.volume_m3[i] -= rest(result.time_s[i], drift);
}

// Returns how far a rest is from the line between the rests beside it, the median.
double wander_of(const KnotLine& rest) {
  std::vector<double> apart;
  for (std::size_t i = 1; i + 1 < rest.time.size(); ++i) {
    const double part = (rest.time[i] - rest.time[i - 1]) / (rest.time[i + 1] - rest.time[i - 1]);
    apart.push_back(std::abs(rest.value[i] - (1 - part) * rest.value[i - 1] - part * rest.value[i + 1]));
  }
  return median(std::move(apart));
}

void add_notes(Segmentation& result, double drift_of_tidal_volume) {
  const double period = median_of(result.breaths, duration_of);
  if (std::abs(drift_of_tidal_volume) > 0.01)
    result.notes.push_back(
        "a drift of " +
        volume_text(drift_of_tidal_volume * median_of(result.breaths, tidal_volume_of), result.calibrated) +
        " a breath was removed");
  if (const double wander = wander_of(result.rest), usual = median_of(result.breaths, tidal_volume_of);
      wander > 0.1 * usual)
    result.notes.push_back("the base line moves by about " + volume_text(wander, result.calibrated) +
                           " from breath to breath: each tidal volume is that uncertain");
  const double before = result.breaths.front().onset_s - result.time_s.front();
  const double after = result.time_s.back() - result.breaths.back().end_s;
  if (result.window) {
    result.notes.push_back(note_of(*result.window));
  } else if (before > 0.05 * period || after > 0.05 * period) {
    result.notes.push_back("not used: " + seconds_text(before) + " before the first and " +
                           seconds_text(after) + " after the last whole breath");
  }
  if (const std::string note = note_of_sizes(result); !note.empty()) result.notes.push_back(note);
}

}  // namespace

Segmentation segment_breaths(const Trace& trace, const BreathSelection& selection) {
  VolumeSignal signal = volume_signal(trace);
  WholeBreaths found = whole_breaths(signal.time_s, signal.volume);
  check_both_ways(trace, found, signal);
  check_any(trace, found);
  Landmarks marks = landmarks(signal.time_s, signal.volume, found);
  // The heart hides where breaths begin and end. It is first seen beside breaths that it has blurred.
  std::vector<double> quiet = signal.volume;
  std::optional<HeartRipple> ripple;
  for (int round = 0; round < 3; ++round) {
    ripple = heart_ripple(signal.time_s, signal.volume, marks, found.drift);
    if (!ripple) break;
    for (std::size_t i = 0; i < quiet.size(); ++i) quiet[i] = signal.volume[i] - ripple->volume[i];
    found = whole_breaths(signal.time_s, quiet);
    marks = landmarks(signal.time_s, quiet, found);
  }

  Segmentation result{std::move(signal.time_s),
                      std::move(signal.volume),
                      {},
                      trace.notes,
                      trace.sigma_m3,
                      trace.source,
                      trace.kind != SignalKind::belt,
                      {},
                      trace.channels,
                      trace.excursion_m,
                      trace.sign,
                      time_window(selection, marks, trace.source)};
  result.notes.insert(result.notes.end(), signal.notes.begin(), signal.notes.end());
  if (result.window) {
    const auto [first, last] = samples_inside(found, *result.window, result.time_s.size());
    found = breaths_inside(found, *result.window, first);
    keep_samples(first, last, result);
    quiet = {quiet.begin() + static_cast<std::ptrdiff_t>(first),
             quiet.begin() + static_cast<std::ptrdiff_t>(last + 1)};
    marks = landmarks(result.time_s, quiet, found);
  }
  if (ripple)
    result.notes.push_back(
        "the heart shows in the signal, " + number_text(s_per_min * ripple->frequency_hz, 2) +
        " times a minute and by about " + volume_text(ripple->amplitude, result.calibrated) +
        ": breaths are placed and sized without it; the volume itself keeps it");
  result.rest = marks.rest;
  result.breaths = breaths_at(marks, result.window ? result.window->first : 1);
  subtract_baseline(marks.rest, found.drift, result);

  const double period = median_of(result.breaths, duration_of),
               volume = median_of(result.breaths, tidal_volume_of);
  check_period(trace, period);
  check_samples(trace, period);
  const bool known = result.calibrated && !selection.calibrate_tidal_volume_m3;
  const auto check_size = [&](double tidal_volume_m3) {
    if (known)
      check_tidal_volume(trace, tidal_volume_m3, period,
                         change_of_unit(result.time_s, result.volume_m3, period));
  };
  check_size(volume);
  check_not_abrupt(result);
  for (std::string& doubt : doubts(trace, result.time_s, result.volume_m3, known, volume, period))
    result.notes.push_back(std::move(doubt));

  const auto shifts = shifts_of(marks, found.drift);
  judge(result, shifts, selection);
  if (const auto kept = kept_of(result.breaths); !kept.empty()) check_size(median_of(kept, tidal_volume_of));
  if (selection.calibrate_tidal_volume_m3) {
    calibrate(result, *selection.calibrate_tidal_volume_m3);
    judge(result, shifts, selection);
  }
  add_notes(result, found.drift * period / volume);
  return result;
}

}  // namespace trunk
