#pragma once

#include <fmt/format.h>

#include "anatomy/trunk_options.hpp"
#include "io/toml_values.hpp"

namespace trunk {

/// Calls visit(table, place) for every [[kind]] table.
template <class Visit>
void for_each_table(std::string_view kind, const toml::node& node, const TomlPlace& place, Visit visit) {
  const toml::array* list = node.as_array();
  if (!list || !list->is_array_of_tables()) place.fail(fmt::format("expected [[{}]] tables", kind));
  for (const toml::node& item : *list)
    visit(*item.as_table(), TomlPlace{place.file, item.source().begin.line});
}

/// A [[rigid]] table. Throws InputError.
RigidPart rigid_part_of(const toml::table& table, const TomlPlace& place);

/// The same as TOML text.
std::string to_toml(const RigidPart& part);

/// "[x, y, z]", and "[[time, value], ...]" with the values divided by `to_si`.
std::string toml_direction(const Vec3d& direction);
std::string toml_events(const PiecewiseLinear& course, double to_si);

}  // namespace trunk
