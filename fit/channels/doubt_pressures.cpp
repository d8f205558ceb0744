#include "channels/doubt_pressures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/units.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr double great_swing_cmH2O = 60, largest_level_cmH2O = 40, least_per_litre = 3, most_per_litre = 100,
                 least_breath_m3 = 150e-6;
constexpr double close_cmH2O = 0.5, close_part = 0.2;

constexpr std::array<std::pair<std::string_view, double>, 3> usual_units{
    {{"cmH2O", Pa_per_cmH2O}, {"kPa", 1000.0}, {"mmHg", Pa_per_mmHg}}};

double swing_cmH2O(const MeasuredChannel& channel) {
  const auto [low, high] = std::minmax_element(channel.value.begin(), channel.value.end());
  return (*high - *low) / Pa_per_cmH2O;
}

std::string large_swing(const MeasuredChannel& channel) {
  const double swing = swing_cmH2O(channel);
  if (!is_pressure(channel.kind) || channel.kind == ChannelKind::airway || swing <= great_swing_cmH2O)
    return "";
  return fmt::format("{} {} swings by {} cmH2O, which only a great effort does: is it in {}?",
                     words_of(channel.kind), excerpt(channel.column), number_text(swing, 3), channel.unit);
}

std::string high_level(const MeasuredChannel& channel) {
  const double level = channel.end_expiratory / Pa_per_cmH2O;
  if (!is_pressure(channel.kind) || std::abs(level) <= largest_level_cmH2O) return "";
  return fmt::format("{} {} is {} cmH2O at the end of expiration, more than bodies have: is it in {}?",
                     words_of(channel.kind), excerpt(channel.column), number_text(level, 3), channel.unit);
}

std::string little_across(const MeasuredBreath& breath) {
  const MeasuredChannel* across = breath.channel(ChannelKind::transdiaphragmatic);
  if (across == nullptr || breath.tidal_volume_m3 < least_breath_m3) return "";
  const double per_litre = swing_cmH2O(*across) / (litres_per_m3 * breath.tidal_volume_m3);
  if (per_litre >= least_per_litre) return "";
  return fmt::format(
      "transdiaphragmatic pressure {} swings by {} cmH2O for each litre of breath: is the diaphragm "
      "paralysed, or is the pressure not in {}?",
      excerpt(across->column), number_text(per_litre, 3), across->unit);
}

std::string odd_per_litre(const MeasuredBreath& breath) {
  const MeasuredChannel* pleural = breath.channel(ChannelKind::pleural);
  if (pleural == nullptr || breath.channel(ChannelKind::airway) != nullptr) return "";
  if (breath.tidal_volume_m3 < least_breath_m3) return "";
  const double per_litre = swing_cmH2O(*pleural) / (litres_per_m3 * breath.tidal_volume_m3);
  if (per_litre >= least_per_litre && per_litre <= most_per_litre) return "";
  return fmt::format(
      "oesophageal pressure {} swings by {} cmH2O for each litre of breath, where lungs take {:g} to {:g}: "
      "is it in {}, and is the volume right?",
      excerpt(pleural->column), number_text(per_litre, 3), least_per_litre, most_per_litre, pleural->unit);
}

}  // namespace

std::string other_unit_of_three(const MeasuredBreath& breath) {
  const std::array channels{breath.channel(ChannelKind::transdiaphragmatic),
                            breath.channel(ChannelKind::gastric), breath.channel(ChannelKind::pleural)};
  if (std::find(channels.begin(), channels.end(), nullptr) != channels.end()) return "";
  // The root of the mean square of what is left if one channel is multiplied, cmH2O.
  const auto left = [&](std::size_t changed, double factor) {
    constexpr std::array<double, 3> signs{1, -1, 1};
    double squares = 0;
    for (std::size_t i = 0; i < breath.time_s.size(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < channels.size(); ++k)
        sum += signs[k] * (k == changed ? factor : 1) * (channels[k]->value[i] + channels[k]->end_expiratory);
      squares += sum * sum;
    }
    return std::sqrt(squares / static_cast<double>(breath.time_s.size())) / Pa_per_cmH2O;
  };
  const double now = left(0, 1);
  for (std::size_t k = 0; k < channels.size(); ++k)
    for (const auto& [said, size] : usual_units)
      for (const auto& [name, other_size] : usual_units) {
        if (channels[k]->unit != said || said == name) continue;
        const double then = left(k, other_size / size);
        if (then > close_part * now || then > close_cmH2O) continue;
        return fmt::format(
            "if {} {} is in {} and not in {}, gastric less oesophageal pressure is the "
            "transdiaphragmatic one to {} cmH2O and not to {}: write the unit into its name",
            words_of(channels[k]->kind), excerpt(channels[k]->column), name, said, number_text(then, 2),
            number_text(now, 2));
      }
  return "";
}

std::vector<std::string> doubt_pressures(const MeasuredBreath& breath) {
  std::vector<std::string> found{other_unit_of_three(breath), odd_per_litre(breath), little_across(breath)};
  for (const MeasuredChannel& channel : breath.channels)
    for (const auto& doubt : {large_swing(channel), high_level(channel)}) found.push_back(doubt);
  std::erase(found, "");
  return found;
}

}  // namespace trunk
