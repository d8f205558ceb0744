#pragma once

#include <vector>

#include "search/least_squares.hpp"

namespace trunk {

/// `count` points of a scrambled Sobol sequence within the bounds; the same seed gives the same points.
/// At most 40 coordinates (GSL's table); those beyond stay at the middle.
std::vector<Eigen::VectorXd> sobol_starts(const LeastSquares& problem, std::size_t count, unsigned seed);

}  // namespace trunk
