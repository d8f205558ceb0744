#include "structure/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/keys.hpp"

namespace trunk {
namespace {

const ScenarioKey& key_named(std::string_view path) {
  const auto keys = scenario_keys();
  return *std::find_if(keys.begin(), keys.end(), [&](const ScenarioKey& k) { return k.path == path; });
}

/// The finest mesh but one: of two neighbouring resolutions, neither is known to be right.
int other_resolution(int resolution) {
  return resolution == 1 ? 2 : resolution - 1;
}

void scale(const ScenarioKey::Number& number, double factor, Scenario& scenario) {
  double& value = number.field(scenario);
  value = std::clamp(factor * value, number.low * number.to_si, number.high * number.to_si);
}

double value_of(const ScenarioKey& key, const Scenario& scenario) {
  Scenario copy = scenario;  // fields of keys can be written
  if (const auto* number = std::get_if<ScenarioKey::Number>(&key.kind))
    return number->field(copy) / number->to_si;
  return std::get<ScenarioKey::Integer>(key.kind).field(copy);
}

}  // namespace

std::span<const Choice> declared_choices() {
  static const std::vector<Choice> choices = {
      {"abdominal_wall",
       {"parameters.abdomen_stiffness_factor"},
       1.6,
       false,
       "our judgement: without a gastric pressure, nothing measured tells the wall from the diaphragm"},
      {"paralysed_softening",
       {"paralysis.stiffness_factor"},
       1.6,
       false,
       "our judgement: the paper speaks of a loss of elasticity and gives no number"},
      {"dome_height",
       {"geometry.dome_height_right_mm", "geometry.dome_height_left_mm"},
       1.15,
       true,
       "our choice: about 10 mm of 70 mm, which no trace shows"},
      {"abdomen_height",
       {"geometry.abdomen_height_mm"},
       1.15,
       true,
       "our choice: about 30 mm of 200 mm, which no trace shows"},
      {"tendon_border",
       {"geometry.tendon_border_fraction"},
       1.05,
       true,
       "our choice: about 6 mm of 126 mm, which no trace shows"},
      {"mesh",
       {"geometry.resolution"},
       0.0,
       true,
       "the next resolution: its difference is the error of the mesh"},
  };
  return choices;
}

void make_choice(const Choice& choice, double place, Scenario& scenario) {
  if (place == 0.0) return;
  for (const std::string_view path : choice.keys) {
    const ScenarioKey& key = key_named(path);
    if (const auto* number = std::get_if<ScenarioKey::Number>(&key.kind)) {
      scale(*number, std::pow(choice.factor, place), scenario);
    } else {
      int& resolution = std::get<ScenarioKey::Integer>(key.kind).field(scenario);
      resolution = other_resolution(resolution);
    }
  }
}

std::string why_left_out(const Choice& choice, const Scenario& scenario) {
  if (choice.of_template && scenario.mesh)
    return fmt::format("{} is left out, because the trunk comes from a file", choice.name);
  if (choice.keys.front().starts_with("paralysis.") && scenario.tissue.paralysed == Side::none)
    return fmt::format("{} is left out, because nothing is paralysed", choice.name);
  return "";
}

Structure::Choice declared_range(const Choice& choice, const Scenario& scenario) {
  const std::string_view path = choice.keys.front();
  const ScenarioKey& key = key_named(path);
  const auto at = [&](double place) {
    Scenario moved = scenario;
    make_choice(choice, place, moved);
    return value_of(key, moved);
  };
  const double own = at(0.0), high = at(1.0), low = choice.is_one_of_two() ? own : at(-1.0);
  return {std::string(choice.name), fmt::format("{}", fmt::join(choice.keys, ", ")),
          unit_of_key(path),        std::string(choice.source),
          std::min(low, high),      own,
          std::max(low, high)};
}

}  // namespace trunk
