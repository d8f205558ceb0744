#include "breaths/segment.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/doubts.hpp"
#include "breaths/landmarks.hpp"
#include "breaths/median_of.hpp"
#include "breaths/one_way.hpp"
#include "breaths/plausibility.hpp"
#include "breaths/volume_signal.hpp"
#include "breaths/whole_breaths.hpp"
#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

std::string seconds(double time_s) {
  return number_text(time_s, 3) + " s";
}

std::string volume_text(double volume_m3, bool calibrated) {
  return calibrated ? number_text(volume_m3 * ml_per_m3, 3) + " ml" : number_text(volume_m3, 3) + " a.u.";
}

void check_any(const Trace& trace, const WholeBreaths& found) {
  if (!found.peak.empty()) return;
  throw InputError({trace.source},
                   "no whole breath in " + seconds(trace.time_s.back() - trace.time_s.front()) + " (" +
                       std::to_string(found.inspirations) + " inspiration(s) seen)",
                   "at least one breath from rest to rest",
                   "give a longer recording, or one that begins and ends at the end of an expiration");
}

std::vector<Breath> breaths_at(const Landmarks& marks) {
  std::vector<Breath> breaths;
  const std::vector<double>&time = marks.rest.time, &value = marks.rest.value;
  for (std::size_t i = 0; i < marks.peak_s.size(); ++i) {
    Breath b{time[i], marks.peak_s[i], time[i + 1], marks.tidal_volume[i], true, ""};
    b.number = i + 1;
    b.pause_s = std::min(marks.rests_s[i + 1], b.expiration_s());
    b.inspired_m3 = b.tidal_volume_m3 + marks.rest(b.peak_s) - value[i];
    b.expired_m3 = b.tidal_volume_m3 + marks.rest(b.peak_s) - value[i + 1];
    breaths.push_back(b);
  }
  return breaths;
}

double duration(const Breath& breath) {
  return breath.duration_s();
}
double tidal_volume(const Breath& breath) {
  return breath.tidal_volume_m3;
}

template <class Text>
std::string far_from_median(const std::string& what, double value, double usual, Text text) {
  if (value < 0.5 * usual) return what + " " + text(value) + " is under half the median " + text(usual);
  if (value > 2 * usual) return what + " " + text(value) + " is over twice the median " + text(usual);
  return "";
}

std::string odd_inspiration(const Breath& breath) {
  const double part = breath.inspiration_s() / breath.duration_s();
  if (part >= 0.1 && part <= 0.9) return "";
  return "inspiration takes " + number_text(100 * part, 2) + " % of the breath";
}

// Returns a reason if the recording ends within the last breath: its expiration is shorter than usual.
std::string cut_off(const Breath& breath, double record_end_s, double usual_expiration_s) {
  const bool at_the_end = record_end_s - breath.end_s < 0.02 * breath.duration_s();
  if (!at_the_end || breath.expiration_s() >= 0.8 * usual_expiration_s) return "";
  return "the recording ends " + seconds(breath.expiration_s()) +
         " into its expiration, which usually lasts " + seconds(usual_expiration_s);
}

template <class Text>
std::string odd_return(const Breath& breath, double shift, Text text) {
  if (std::abs(shift) <= 0.5 * breath.tidal_volume_m3) return "";
  return "ends " + text(std::abs(shift)) + (shift > 0 ? " above" : " below") +
         " where it began, over half of its tidal volume " + text(breath.tidal_volume_m3);
}

// Returns how far the rest moves over each breath, in parts of the tidal volume, beyond the median drift or
// the drift over a neighbouring breath. A wandering base line moves neighbours alike; a shift moves one
// breath.
std::vector<double> shifts_of(const Landmarks& marks, double drift) {
  const std::vector<double>&time = marks.rest.time, &value = marks.rest.value;
  const auto slope = [&](std::size_t k) { return (value[k + 1] - value[k]) / (time[k + 1] - time[k]); };
  std::vector<double> shifts;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    double sudden = slope(i) - drift;
    const auto compare = [&](double other) {
      if (std::abs(slope(i) - other) < std::abs(sudden)) sudden = slope(i) - other;
    };
    if (i > 0) compare(slope(i - 1));
    if (i + 2 < time.size()) compare(slope(i + 1));
    shifts.push_back(sudden * (time[i + 1] - time[i]) / marks.tidal_volume[i]);
  }
  return shifts;
}

// Judges every breath and writes its reason, in the present unit of volume. => result.breaths
void judge(Segmentation& result, const std::vector<double>& shifts, const BreathSelection& selection) {
  const double usual_volume = median_of(result.breaths, tidal_volume);
  const double usual_duration = median_of(result.breaths, duration);
  const double usual_expiration = median_of(result.breaths, [](const Breath& b) { return b.expiration_s(); });
  const auto volume = [&](double v) { return volume_text(v, result.calibrated); };
  for (std::size_t i = 0; i < result.breaths.size(); ++i) {
    Breath& breath = result.breaths[i];
    breath.kept = true, breath.reason = "";
    for (const auto& reason :
         {far_from_median("tidal volume", breath.tidal_volume_m3, usual_volume, volume),
          far_from_median("duration", breath.duration_s(), usual_duration, seconds), odd_inspiration(breath),
          odd_return(breath, shifts[i] * breath.tidal_volume_m3, volume),
          cut_off(breath, result.time_s.back(), usual_expiration)}) {
      if (reason.empty()) continue;
      breath.kept = false;
      breath.reason += (breath.reason.empty() ? "" : "; ") + reason;
    }
  }
  overrule(result.breaths, selection, result.source);
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
  const double found = median_of(kept.empty() ? result.breaths : kept, tidal_volume);
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

void subtract_baseline(VolumeSignal& signal, const KnotLine& rest, double drift) {
  for (std::size_t i = 0; i < signal.time_s.size(); ++i) signal.volume[i] -= rest(signal.time_s[i], drift);
}

void add_notes(Segmentation& result, double drift_of_tidal_volume) {
  const double period = median_of(result.breaths, duration);
  if (std::abs(drift_of_tidal_volume) > 0.01)
    result.notes.push_back(
        "a drift of " +
        volume_text(drift_of_tidal_volume * median_of(result.breaths, tidal_volume), result.calibrated) +
        " a breath was removed");
  const double before = result.breaths.front().onset_s - result.time_s.front();
  const double after = result.time_s.back() - result.breaths.back().end_s;
  if (before > 0.05 * period || after > 0.05 * period)
    result.notes.push_back("not used: " + seconds(before) + " before the first and " + seconds(after) +
                           " after the last whole breath");
}

}  // namespace

Segmentation segment_breaths(const Trace& trace, const BreathSelection& selection) {
  VolumeSignal signal = volume_signal(trace);
  const WholeBreaths found = whole_breaths(signal.time_s, signal.volume);
  check_both_ways(trace, found, signal);
  check_any(trace, found);
  const Landmarks marks = landmarks(signal.time_s, signal.volume, found);
  subtract_baseline(signal, marks.rest, found.drift);

  Segmentation result{std::move(signal.time_s),
                      std::move(signal.volume),
                      breaths_at(marks),
                      trace.notes,
                      trace.sigma_m3,
                      trace.source,
                      trace.kind != SignalKind::belt,
                      marks.rest,
                      trace.channels,
                      trace.excursion_m,
                      trace.sign};
  result.notes.insert(result.notes.end(), signal.notes.begin(), signal.notes.end());
  const double period = median_of(result.breaths, duration), volume = median_of(result.breaths, tidal_volume);
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
  if (const auto kept = kept_of(result.breaths); !kept.empty()) check_size(median_of(kept, tidal_volume));
  if (selection.calibrate_tidal_volume_m3) {
    calibrate(result, *selection.calibrate_tidal_volume_m3);
    judge(result, shifts, selection);
  }
  add_notes(result, found.drift * period / volume);
  return result;
}

}  // namespace trunk
