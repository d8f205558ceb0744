#pragma once

#include <vector>

#include "search/least_squares.hpp"

namespace trunk {

/// Returns `count` points of a randomly shifted Sobol sequence within the bounds; the same seed gives the
/// same points. GSL's table has 40 coordinates; any further coordinate stays in the middle of its bounds.
std::vector<Eigen::VectorXd> sobol_starts(const LeastSquares& problem, std::size_t count, unsigned seed);

}  // namespace trunk
