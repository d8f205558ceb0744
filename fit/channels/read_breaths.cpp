#include "channels/read_breaths.hpp"

#include <fmt/format.h>

#include "channels/check_channels.hpp"
#include "channels/doubt_pressures.hpp"
#include "gates/upside_down.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

// Whether the breaths can be averaged: a belt has a scale, and one breath is kept.
bool has_mean(const Segmentation& s) {
  bool kept = false;
  for (const Breath& b : s.breaths) kept = kept || b.kept;
  return s.calibrated && kept;
}

void turn(Trace& trace) {
  for (double& value : trace.value) value = -value;
}

// Returns whether only the pressure can tell which way is up.
bool open_to_pressure(const Trace& trace, const Segmentation& s) {
  return trace.sign == SignShownBy::shape && !trace.inverted_by_user &&
         orientation(s, breaths_to_judge(s)).upright != Upright::yes;
}

}  // namespace

Segmentation breaths_of(Trace trace, const BreathSelection& selection) {
  Segmentation s = segment_breaths(trace, selection);
  if (trace.channels.empty() || !has_mean(s)) return s;
  MeasuredBreath mean = mean_breath(s);
  check_channels(mean, s.source);
  if (const MeasuredChannel* pleural = mean.channel(ChannelKind::pleural)) {
    PressureSign sign = pressure_sign(mean);
    if (sign.clear && !sign.rises) {
      if (!open_to_pressure(trace, s)) throw wrong_way(mean, sign, s.source);
      trace.notes.push_back(fmt::format(
          "the signal is turned, since oesophageal pressure {} would rise on inspiration otherwise: "
          "volume and flow explain {:.0f} % of its variance, where 50 % are asked for",
          excerpt(pleural->column), percent_per_one * sign.explained));
      turn(trace);
      s = segment_breaths(trace, selection);
      mean = mean_breath(s);
      sign = pressure_sign(mean);
    }
    if (sign.clear && sign.rises) s.sign = SignShownBy::pressure;
  }
  for (std::string& doubt : doubt_pressures(mean)) s.notes.push_back(std::move(doubt));
  for (std::string& doubt : doubts_about(mean)) s.notes.push_back(std::move(doubt));
  for (const MeasuredChannel& channel : mean.channels)
    s.notes.insert(s.notes.end(), channel.notes.begin(), channel.notes.end());
  return s;
}

Segmentation read_breaths(const std::filesystem::path& path, const SignalOptions& options,
                          const BreathSelection& selection) {
  return breaths_of(read_signal(path, options), selection);
}

}  // namespace trunk
