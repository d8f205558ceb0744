#pragma once

#include <fmt/format.h>

#include "anatomy/trunk_options.hpp"
#include "errors/input_error.hpp"
#include "scenarios/toml_values.hpp"

namespace trunk {

/// Calls visit(table, place) for every [[kind]] table; throws the mistakes of all tables together.
template <class Visit>
void for_each_table(std::string_view kind, const toml::node& node, const Place& place, Visit visit) {
  const toml::array* list = node.as_array();
  if (!list || !list->is_array_of_tables())
    throw InputError(place, fmt::format("{} is {}", kind, shown(node)), fmt::format("[[{}]] tables", kind));
  Mistakes mistakes;
  for (const toml::node& item : *list)
    mistakes.gather([&] { visit(*item.as_table(), Place{place.file, item.source().begin.line}); });
  mistakes.settle();
}

/// Calls read(key, value, place) for every key of a table; throws the mistakes of all keys together.
template <class Read>
void for_each_key(const toml::table& table, const Place& place, Read read) {
  Mistakes mistakes;
  for (const auto& [key, value] : table)
    mistakes.gather([&, &k = key, &v = value] {
      read(std::string(k.str()), v, Place{place.file, k.source().begin.line});
    });
  mistakes.settle();
}

/// Returns the part that a [[rigid]] table describes; throws InputError.
RigidPart rigid_part_of(const toml::table& table, const Place& place);

/// Returns a part as TOML.
std::string to_toml(const RigidPart& part);

/// Returns "[x, y, z]".
std::string toml_direction(const Vec3d& direction);

}  // namespace trunk
