#include "constraints/volume_root.hpp"

#include <gsl/gsl_poly.h>

#include <array>

namespace trunk {
namespace {

std::optional<double> nearest_to_zero(const std::array<double, 3>& roots, int count) {
  std::optional<double> nearest;
  for (int i = 0; i < count; ++i) {
    const double root = roots[static_cast<std::size_t>(i)];
    if (!nearest || std::abs(root) < std::abs(*nearest)) nearest = root;
  }
  return nearest;
}

}  // namespace

std::optional<double> nearest_real_root(const VolumeCubic<double>& cubic, double target) noexcept {
  const double d = cubic.c0 - target;
  if (!finite(d) || !finite(cubic.c1) || !finite(cubic.c2) || !finite(cubic.c3)) return std::nullopt;
  std::array<double, 3> roots{};
  int count = 0;
  if (cubic.c3 != 0.0)
    count = gsl_poly_solve_cubic(cubic.c2 / cubic.c3, cubic.c1 / cubic.c3, d / cubic.c3, &roots[0], &roots[1],
                                 &roots[2]);
  else
    count = gsl_poly_solve_quadratic(cubic.c2, cubic.c1, d, &roots[0], &roots[1]);
  return nearest_to_zero(roots, count);
}

}  // namespace trunk
