#pragma once

#include "commands/text/output.hpp"
#include "comparison/compare.hpp"

namespace CLI {
class App;
}

namespace trunk {

/// `same`, `compared`, `farthest_m` and one object a difference.
Json comparison_json(const Comparison& comparison);

/// One line a difference, with both numbers; nothing where all is the same.
std::string comparison_table(const Comparison& comparison);

/// "--tolerance" and "--absolute".
void add_tolerance_options(CLI::App& command, Tolerance& tolerance);

}  // namespace trunk
