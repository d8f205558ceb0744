#pragma once

#include <cstddef>
#include <vector>

namespace trunk {

/// Returns a Latin hypercube (McKay, Beckman and Conover 1979) in the unit cube, [coordinates][points] in [0,
/// 1). Along every coordinate, each of `points` equal intervals holds one point at a random place. The same
/// seed gives the same points.
std::vector<std::vector<double>> latin_hypercube(std::size_t coordinates, std::size_t points, unsigned seed);

/// Returns a Sobol sequence with a random shift, [coordinates][points] in [0, 1), for at most 40 coordinates.
/// The same seed gives the same points.
std::vector<std::vector<double>> sobol_points(std::size_t coordinates, std::size_t points, unsigned seed);

}  // namespace trunk
