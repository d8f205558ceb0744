#pragma once

#include <span>

#include "anatomy/scenario.hpp"
#include "scenarios/toml_values.hpp"

namespace trunk {

/// How a kind of load is written: [[table]] with its course under `events`, in units of which one is `to_si`.
struct LoadKey {
  RegionLoad::Kind kind;
  std::string_view table, events;
  double to_si;
};
std::span<const LoadKey> load_keys();

/// Reads the keys of a scenario that are not plain values: schema, extends (handled by the caller), gravity,
/// the course of the abdominal volume, loads (also of an LML file) and [[rigid]] parts. Returns false for any
/// other key. Throws InputError.
bool read_special(const std::string& path, const toml::node& node, const TomlPlace& place,
                  Scenario& scenario);

}  // namespace trunk
