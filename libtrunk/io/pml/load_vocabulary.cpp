#include "pml/load_vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "errors/input_error.hpp"
#include "pml/text_values.hpp"

namespace trunk::pml {
namespace {

using enum Load::Type;

struct TypeName {
  Load::Type type;
  std::string_view name;
};

constexpr TypeName type_names[] = {{translation, "Translation"},
                                   {force, "Force"},
                                   {pressure, "Pressure"},
                                   {rotation, "Rotation"},
                                   {acceleration, "Acceleration"}};

struct Unit {
  Load::Type type;
  std::string_view name;
  double si;
};

constexpr double degree = std::numbers::pi / 180.0;

constexpr Unit units[] = {{translation, "", 1e-3},
                          {translation, "mm", 1e-3},
                          {translation, "m", 1.0},
                          {translation, "cm", 1e-2},
                          {translation, "µm", 1e-6},
                          {translation, "nm", 1e-9},
                          {force, "", 1.0},
                          {force, "N", 1.0},
                          {force, "kN", 1e3},
                          {force, "mN", 1e-3},
                          {pressure, "Pa", 1.0},
                          {pressure, "hPa", 1e2},
                          {pressure, "kPa", 1e3},
                          {pressure, "cmH2O", 98.0665},
                          {pressure, "mmHg", 133.322387415},
                          {rotation, "", 1.0},
                          {rotation, "rad", 1.0},
                          {rotation, "radians", 1.0},
                          {rotation, "deg", degree},
                          {rotation, "degrees", degree},
                          {rotation, "°", degree},
                          {acceleration, "", 1.0},
                          {acceleration, "m/s2", 1.0},
                          {acceleration, "m/s²", 1.0},
                          {acceleration, "m/s^2", 1.0},
                          {acceleration, "mm/s2", 1e-3},
                          {acceleration, "mm/s²", 1e-3},
                          {acceleration, "mm/s^2", 1e-3}};

}  // namespace

std::string_view name_of(Load::Type type) noexcept {
  return std::find_if(std::begin(type_names), std::end(type_names),
                      [&](const TypeName& known) { return known.type == type; })
      ->name;
}

std::optional<Load::Type> load_type(std::string_view name) noexcept {
  const auto at = std::find_if(std::begin(type_names), std::end(type_names),
                               [&](const TypeName& known) { return known.name == name; });
  return at == std::end(type_names) ? std::nullopt : std::optional(at->type);
}

std::string load_type_names() {
  std::vector<std::string_view> names;
  for (const TypeName& known : type_names) names.push_back(known.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<double> si_factor(Load::Type type, std::string_view unit) noexcept {
  const auto at = std::find_if(std::begin(units), std::end(units),
                               [&](const Unit& known) { return known.type == type && known.name == unit; });
  return at == std::end(units) ? std::nullopt : std::optional(at->si);
}

std::string unit_names(Load::Type type) {
  std::vector<std::string_view> names;
  for (const Unit& known : units)
    if (known.type == type && !known.name.empty()) names.push_back(known.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

double to_si(const Load& load) {
  const auto factor = si_factor(load.type, load.unit);
  if (!factor)
    throw InputError(fmt::format("a {} in unit {}, expected {}; correct its unit", name_of(load.type),
                                 cited(load.unit), unit_names(load.type)));
  return *factor;
}

}  // namespace trunk::pml
