#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pml/loads.hpp"

namespace trunk::pml {

/// Returns the name that xsi:type has for a type of load, such as "Translation".
std::string_view name_of(Load::Type type) noexcept;
/// Returns the type of load of that name, or nothing.
std::optional<Load::Type> load_type(std::string_view name) noexcept;
/// Returns all names for messages: "Translation, Force, …".
std::string load_type_names();

/// Returns how many m, N, Pa, rad or m/s² one unit is, or nothing if this type of load does not have the
/// unit. Without a unit, the values are in mm, N, rad or m/s². A pressure must name its unit, since Pa and
/// kPa are both in use.
std::optional<double> si_factor(Load::Type type, std::string_view unit) noexcept;
/// Returns the units of a type of load for messages: "mm, m, …".
std::string unit_names(Load::Type type);

/// Returns the factor from the unit of a load to SI; throws InputError if the unit is not known.
double to_si(const Load& load);

}  // namespace trunk::pml
