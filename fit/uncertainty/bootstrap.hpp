#pragma once

#include "uncertainty/refit.hpp"

namespace trunk {

/// The spread of repeated fits to resampled residuals.
struct Bootstrap {
  int repeats = 0;
  int block = 0;                     // samples
  std::vector<Interval> interval95;  // [asked for], percentiles, natural units
  Interval ratio95;                  // of k_muscle / k_elasticity; 0, 0 if k_muscle is not free
};

/// Returns the moving-block bootstrap of the residuals (Kunsch 1989). Blocks of 3 / (1 - rho) samples, at
/// least 5 and at most a quarter of the curve, keep the correlation of neighbours (the length is our choice).
/// Each repeat is a new fit that starts at the best point.
Bootstrap bootstrap(Objective& objective, const LocalFit& fit, int repeats, unsigned seed);

}  // namespace trunk
