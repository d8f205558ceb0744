#include "channels/check_channels.hpp"

#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "channels/doubt_pressures.hpp"
#include "clinic/lung_mechanics.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr double least_swing_cmH2O = 0.05, largest_swing_cmH2O = 150;
constexpr double least_excursion_m = 1e-3, largest_excursion_m = 0.15;
constexpr double usual_swing_cmH2O = 8;
constexpr double least_difference_cmH2O = 0.5, difference_of_swing = 0.1, wrong_of_swing = 0.25;
constexpr double clear_share = 0.5, least_apart = 0.02, against = -0.5;

struct PressureUnit {
  std::string_view name;
  double Pa;
};
constexpr std::array pressure_units{PressureUnit{"cmH2O", Pa_per_cmH2O}, PressureUnit{"kPa", 1000},
                                    PressureUnit{"mmHg", Pa_per_mmHg}, PressureUnit{"Pa", 1}};

double swing_of(const std::vector<double>& curve) {
  const auto [low, high] = std::minmax_element(curve.begin(), curve.end());
  return *high - *low;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  return gsl_stats_correlation(a.data(), 1, b.data(), 1, a.size());
}

std::string none_of(const MeasuredChannel& channel) {
  return fmt::format("leave it out with --{} none", option_of(channel.kind));
}

// Returns the unit with which a swing would be nearest to a usual one, or "". `unit`: as it is read.
std::string_view better_unit(double swing_cmH2O, std::string_view unit) {
  const auto from = std::find_if(pressure_units.begin(), pressure_units.end(),
                                 [&](const PressureUnit& u) { return u.name == unit; });
  if (from == pressure_units.end()) return "";
  std::string_view best;
  double distance = std::log(10.0);  // a factor of 10 from the usual one
  for (const PressureUnit& u : pressure_units) {
    const double d = std::abs(std::log(swing_cmH2O * u.Pa / from->Pa / usual_swing_cmH2O));
    if (d < distance) distance = d, best = u.name;
  }
  return best;
}

void check_pressure_swing(const MeasuredChannel& channel, const std::string& source) {
  const double swing = swing_of(channel.value) / Pa_per_cmH2O;
  const double least = channel.kind == ChannelKind::airway ? 0 : least_swing_cmH2O;
  if (swing >= least && swing <= largest_swing_cmH2O) return;
  const std::string_view unit = better_unit(swing, channel.unit);
  throw InputError(
      {source},
      fmt::format("{} {} swings by {} cmH2O in the mean breath, read in {}", words_of(channel.kind),
                  excerpt(channel.column), number_text(swing, 3), channel.unit),
      fmt::format("{:g} to {:g} cmH2O", least, largest_swing_cmH2O),
      (unit.empty() ? "check its unit" : fmt::format("if it is in {0}, give --pressure-unit {0}", unit)) +
          ", or " + none_of(channel));
}

void check_swing(const MeasuredChannel& channel, const std::string& source) {
  if (is_pressure(channel.kind)) return check_pressure_swing(channel, source);
  const double swing = swing_of(channel.value);
  if (channel.kind == ChannelKind::emg) {
    if (swing > 0) return;
    throw InputError({source}, fmt::format("EMG {} does not change", excerpt(channel.column)),
                     "one that rises on inspiration", none_of(channel));
  }
  if (swing >= least_excursion_m && swing <= largest_excursion_m) return;
  throw InputError(
      {source},
      fmt::format("excursion {} moves by {} mm in the mean breath, read in {}", excerpt(channel.column),
                  number_text(mm_per_m * swing, 3), channel.unit),
      fmt::format("{:g} to {:g} mm", mm_per_m * least_excursion_m, mm_per_m * largest_excursion_m),
      "write its unit into the name, as in excursion_mm, or " + none_of(channel));
}

void check_difference(const MeasuredBreath& breath, const std::string& source) {
  const MeasuredChannel *across = breath.channel(ChannelKind::transdiaphragmatic),
                        *gastric = breath.channel(ChannelKind::gastric),
                        *pleural = breath.channel(ChannelKind::pleural);
  if (across == nullptr || gastric == nullptr || pleural == nullptr) return;
  const auto deviation = [&](double sign) {
    double squares = 0;
    for (std::size_t i = 0; i < across->value.size(); ++i) {
      const double off = sign * across->value[i] - (gastric->value[i] - pleural->value[i]);
      squares += off * off;
    }
    return std::sqrt(squares / static_cast<double>(across->value.size()));
  };
  const double limit =
      std::max(least_difference_cmH2O * Pa_per_cmH2O, difference_of_swing * swing_of(across->value));
  if (deviation(1) <= limit) return;
  const bool turned = deviation(-1) <= limit;
  const std::string unit = other_unit_of_three(breath);
  throw InputError(
      {source},
      fmt::format(
          "transdiaphragmatic pressure {} is not gastric {} less oesophageal {}: they differ by {} cmH2O "
          "(root of the mean square)",
          excerpt(across->column), excerpt(gastric->column), excerpt(pleural->column),
          number_text(deviation(1) / Pa_per_cmH2O, 3)),
      fmt::format("at most {} cmH2O", number_text(limit / Pa_per_cmH2O, 3)),
      turned          ? "its sign is reversed: --invert-channel pdi"
      : !unit.empty() ? unit
                      : "correct the columns, or leave one of them out, as in --pdi none");
}

// A catheter may lie in the wrong place, or a column be named twice.
void check_apart(const MeasuredBreath& breath, const std::string& source) {
  const MeasuredChannel *gastric = breath.channel(ChannelKind::gastric),
                        *pleural = breath.channel(ChannelKind::pleural);
  if (gastric == nullptr || pleural == nullptr) return;
  double squares = 0;
  for (std::size_t i = 0; i < gastric->value.size(); ++i)
    squares += std::pow(gastric->value[i] - pleural->value[i], 2);
  const double apart = std::sqrt(squares / static_cast<double>(gastric->value.size()));
  if (apart > least_apart * swing_of(pleural->value)) return;
  throw InputError({source},
                   fmt::format("gastric pressure {} is the same as oesophageal pressure {}",
                               excerpt(gastric->column), excerpt(pleural->column)),
                   "pressures above and below the diaphragm", "leave one of them out, as in --pga none");
}

void check_across_sign(const MeasuredBreath& breath, const std::string& source) {
  const MeasuredChannel* across = breath.channel(ChannelKind::transdiaphragmatic);
  if (across == nullptr) return;
  double in = 0, out = 0, count_in = 0, count_out = 0;
  for (std::size_t i = 0; i < across->value.size(); ++i)
    if (breath.time_s[i] <= breath.inspiration_s)
      in += across->value[i], ++count_in;
    else
      out += across->value[i], ++count_out;
  const double rise = in / count_in - out / count_out;
  if (rise >= -wrong_of_swing * swing_of(across->value)) return;
  throw InputError({source},
                   fmt::format("transdiaphragmatic pressure {} falls by {} cmH2O on inspiration",
                               excerpt(across->column), number_text(-rise / Pa_per_cmH2O, 3)),
                   "gastric less oesophageal pressure, which rises",
                   "turn its sign with --invert-channel pdi, or " + none_of(*across));
}

}  // namespace

void check_channels(const MeasuredBreath& breath, const std::string& source) {
  Mistakes mistakes;
  for (const MeasuredChannel& channel : breath.channels)
    mistakes.gather([&] { check_swing(channel, source); });
  if (mistakes.empty()) mistakes.gather([&] { check_apart(breath, source); });
  if (mistakes.empty()) mistakes.gather([&] { check_difference(breath, source); });
  if (mistakes.empty()) mistakes.gather([&] { check_across_sign(breath, source); });
  mistakes.settle();
}

std::vector<std::string> doubts_about(const MeasuredBreath& breath) {
  std::vector<std::string> doubts;
  for (const ChannelKind kind : {ChannelKind::gastric, ChannelKind::excursion}) {
    const MeasuredChannel* channel = breath.channel(kind);
    if (channel == nullptr) continue;
    const double goes_along = correlation(channel->value, breath.volume_m3);
    if (goes_along < against)
      doubts.push_back(
          fmt::format("{} {} falls as the volume rises (correlation {:.2f}), as it does if the diaphragm is "
                      "weak; if its sign is reversed, --invert-channel {} turns it",
                      words_of(kind), excerpt(channel->column), goes_along, option_of(kind)));
  }
  return doubts;
}

PressureSign pressure_sign(const MeasuredBreath& breath) {
  const LungMechanics lung = lung_mechanics(mean_loop(breath));
  return {lung.rise_Pa >= 0, lung.explained > clear_share, lung.explained, lung.rise_Pa};
}

InputError wrong_way(const MeasuredBreath& breath, const PressureSign& sign, const std::string& source) {
  const MeasuredChannel& pleural = *breath.channel(ChannelKind::pleural);
  const bool airway = breath.channel(ChannelKind::airway) != nullptr;
  return {{source},
          fmt::format("oesophageal pressure {} moves the wrong way: it rises by {} cmH2O on inspiration{}",
                      excerpt(pleural.column), number_text(-sign.rise_Pa / Pa_per_cmH2O, 3),
                      airway ? " against airway pressure" : ""),
          "one that falls",
          fmt::format("turn it with --invert-channel poes, or the signal with --invert{}; or {}",
                      airway ? "" : "; name the airway pressure with --paw if a ventilator gives the breaths",
                      none_of(pleural))};
}

}  // namespace trunk
