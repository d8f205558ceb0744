#include "sweep/sampling.hpp"

#include <numeric>
#include <random>

#include "search/multistart.hpp"

namespace trunk {

std::vector<std::vector<double>> latin_hypercube(std::size_t coordinates, std::size_t points, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::vector<std::vector<double>> cube(coordinates, std::vector<double>(points));
  for (auto& coordinate : cube) {
    std::vector<std::size_t> interval(points);
    std::iota(interval.begin(), interval.end(), std::size_t{0});
    // std::shuffle gives another order in another standard library.
    for (std::size_t i = points; i > 1; --i) std::swap(interval[i - 1], interval[engine() % i]);
    for (std::size_t i = 0; i < points; ++i) {
      const double place = static_cast<double>(engine() >> 11) * 0x1p-53;
      coordinate[i] = (static_cast<double>(interval[i]) + place) / static_cast<double>(points);
    }
  }
  return cube;
}

std::vector<std::vector<double>> sobol_points(std::size_t coordinates, std::size_t points, unsigned seed) {
  const auto n = static_cast<Eigen::Index>(coordinates);
  const LeastSquares unit{{}, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Ones(n)};
  std::vector<std::vector<double>> cube(coordinates, std::vector<double>());
  for (const Eigen::VectorXd& point : sobol_starts(unit, points, seed))
    for (std::size_t i = 0; i < coordinates; ++i) cube[i].push_back(point[static_cast<Eigen::Index>(i)]);
  return cube;
}

}  // namespace trunk
