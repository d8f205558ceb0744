#pragma once

#include <span>

#include "anatomy/scenario.hpp"
#include "scenarios/toml_values.hpp"

namespace trunk {

/// The name of the table of one kind of load, the key of its events, and the factor from their unit to SI.
struct LoadKey {
  RegionLoad::Kind kind;
  std::string_view table, events;
  double to_si;
};
std::span<const LoadKey> load_keys();

/// Reads the keys of a scenario that are not plain values: schema, extends (handled by the caller), gravity,
/// the abdominal volume over time, loads (also from an LML file) and [[rigid]] parts. Returns false for any
/// other key. Throws InputError.
bool read_special(const std::string& path, const toml::node& node, const Place& place, Scenario& scenario);

}  // namespace trunk
