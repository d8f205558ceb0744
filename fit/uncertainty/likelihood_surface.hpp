#pragma once

#include "uncertainty/profiles.hpp"

namespace trunk {

/// The likelihood over a grid of the two parameters asked for. All other
/// parameters are fitted again at each point.
struct LikelihoodSurface {
  std::string names[2], units[2];
  std::vector<double> axis[2];   // [n] each; the axis of k_muscle is the ratio k_muscle/k_elasticity
  std::vector<double> deviance;  // [n * n], the second axis fastest
  double threshold95 = 0.0;      // of the joint 95 % region: 2 F(0.95; 2, freedom)
  Interval region95[2];          // extent of the joint region along each axis
  bool closed = false;           // the region does not touch the edge of the grid
};

/// Returns the surface with `points` along each axis, which spans 4 standard errors on either side of the
/// best point, or ends at the bounds. Exactly two parameters must be asked for.
LikelihoodSurface likelihood_surface(Objective& objective, const LocalFit& fit, int points);

}  // namespace trunk
