#pragma once

#include "commands/text/output.hpp"
#include "comparison/compare.hpp"

namespace CLI {
class App;
}

namespace trunk {

/// Returns `same`, `compared`, `farthest_m` and one object for each difference.
Json comparison_json(const Comparison& comparison);

/// Returns one line with both numbers for each difference; "" if there is none.
std::string comparison_table(const Comparison& comparison);

/// Adds --tolerance and --absolute.
void add_tolerance_options(CLI::App& command, Tolerance& tolerance);

}  // namespace trunk
