#pragma once

#include "anatomy/scenario.hpp"
#include "io/toml_values.hpp"

namespace trunk {

/// Reads the keys of a scenario that are not plain values: schema, extends (handled by the caller), gravity,
/// the course of the abdominal volume, [[force]] and [[displacement]]. Returns false for any other key.
/// Throws InputError.
bool read_special(const std::string& path, const toml::node& node, const TomlPlace& place,
                  Scenario& scenario);

}  // namespace trunk
