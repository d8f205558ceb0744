#include "pml/load_vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "text/message_text.hpp"

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

constexpr Unit units[] = {{translation, "", m_per_mm},
                          {translation, "mm", m_per_mm},
                          {translation, "m", 1.0},
                          {translation, "cm", 1e-2},
                          {translation, "µm", 1e-6},
                          {translation, "micron", 1e-6},
                          {translation, "nm", 1e-9},
                          {force, "", 1.0},
                          {force, "N", 1.0},
                          {force, "kN", 1e3},
                          {force, "mN", 1e-3},
                          {force, "pN", 1e-12},
                          {pressure, "Pa", 1.0},
                          {pressure, "hPa", 1e2},
                          {pressure, "kPa", 1e3},
                          {pressure, "cmH2O", Pa_per_cmH2O},
                          {pressure, "mmHg", Pa_per_mmHg},
                          {rotation, "", 1.0},
                          {rotation, "rad", 1.0},
                          {rotation, "radian", 1.0},
                          {rotation, "radians", 1.0},
                          {rotation, "deg", rad_per_degree},
                          {rotation, "degree", rad_per_degree},
                          {rotation, "degrees", rad_per_degree},
                          {rotation, "°", rad_per_degree},
                          {acceleration, "", 1.0},
                          {acceleration, "m/s2", 1.0},
                          {acceleration, "m/s²", 1.0},
                          {acceleration, "m/s^2", 1.0},
                          {acceleration, "cm/s2", 1e-2},
                          {acceleration, "cm/s²", 1e-2},
                          {acceleration, "cm/s^2", 1e-2},
                          {acceleration, "mm/s2", m_per_mm},
                          {acceleration, "mm/s²", m_per_mm},
                          {acceleration, "mm/s^2", m_per_mm}};

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
    throw InputError({}, fmt::format("a {} in unit {}", name_of(load.type), excerpt(load.unit)),
                     unit_names(load.type), "correct its unit");
  return *factor;
}

}  // namespace trunk::pml
