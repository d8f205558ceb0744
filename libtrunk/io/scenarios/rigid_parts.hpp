#pragma once

#include <fmt/format.h>

#include "anatomy/trunk_options.hpp"
#include "errors/input_error.hpp"
#include "scenarios/toml_values.hpp"

namespace trunk {

/// Calls visit(table, place) for every [[kind]] table; the mistakes of all are thrown together.
template <class Visit>
void for_each_table(std::string_view kind, const toml::node& node, const TomlPlace& place, Visit visit) {
  const toml::array* list = node.as_array();
  if (!list || !list->is_array_of_tables()) place.fail(fmt::format("expected [[{}]] tables", kind));
  Mistakes mistakes;
  for (const toml::node& item : *list)
    mistakes.gather([&] { visit(*item.as_table(), TomlPlace{place.file, item.source().begin.line}); });
  mistakes.settle();
}

/// Calls read(key, value, place) for every key of a table; the mistakes of all are thrown together.
template <class Read>
void for_each_key(const toml::table& table, const TomlPlace& place, Read read) {
  Mistakes mistakes;
  for (const auto& [key, value] : table)
    mistakes.gather([&, &k = key, &v = value] {
      read(std::string(k.str()), v, TomlPlace{place.file, k.source().begin.line});
    });
  mistakes.settle();
}

/// A [[rigid]] table. Throws InputError.
RigidPart rigid_part_of(const toml::table& table, const TomlPlace& place);

/// The same as TOML text.
std::string to_toml(const RigidPart& part);

/// "[x, y, z]", and "[[time, value], ...]" with the values divided by `to_si`.
std::string toml_direction(const Vec3d& direction);
std::string toml_events(const PiecewiseLinear& course, double to_si);

}  // namespace trunk
