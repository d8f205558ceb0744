#pragma once

#include "uncertainty/profiles.hpp"

namespace trunk {

/// The likelihood over a grid of the two parameters asked for. What is estimated beside them follows to first
/// order.
struct LikelihoodSurface {
  std::string names[2], units[2];
  std::vector<double> axis[2];   // first parameter [n]; of k_muscle the ratio k_muscle/k_elasticity [n]
  std::vector<double> deviance;  // [n * n], the second fastest; NaN where the model fails
  double threshold95 = 0.0;      // of the joint 95 % region: 2 F(0.95; 2, freedom)
  Interval region95[2];          // what the joint region spans
  bool closed = false;           // the region does not touch the edge of the grid
};

/// `points` along each axis, over 4 standard errors around the best or up to the bounds. Only for two
/// parameters asked for.
LikelihoodSurface likelihood_surface(Objective& objective, const LocalFit& fit, int points);

}  // namespace trunk
