#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pml/loads.hpp"

namespace trunk::pml {

/// "Translation", as xsi:type names it.
std::string_view name_of(Load::Type type) noexcept;
std::optional<Load::Type> load_type(std::string_view name) noexcept;
/// "Translation, Force, …", for messages.
std::string load_type_names();

/// How many m, N, Pa, rad or m/s² one unit is; nothing for a unit that this type of load has not. No unit
/// means mm, N, rad, m/s²; a pressure must name its own, since Pa and kPa are both in use.
std::optional<double> si_factor(Load::Type type, std::string_view unit) noexcept;
/// "mm, m, …", for messages.
std::string unit_names(Load::Type type);

/// The same of a load. Throws InputError for an unknown unit.
double to_si(const Load& load);

}  // namespace trunk::pml
