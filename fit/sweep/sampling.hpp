#pragma once

#include <cstddef>
#include <vector>

namespace trunk {

/// Points in the unit cube, [coordinates][points], each coordinate in [0, 1). The same seed gives the same
/// points.

/// Latin hypercube (McKay, Beckman and Conover 1979): along every coordinate one point in each of `points`
/// equal intervals, at a random place in it.
std::vector<std::vector<double>> latin_hypercube(std::size_t coordinates, std::size_t points, unsigned seed);

/// A Sobol sequence with a random shift. At most 40 coordinates.
std::vector<std::vector<double>> sobol_points(std::size_t coordinates, std::size_t points, unsigned seed);

}  // namespace trunk
