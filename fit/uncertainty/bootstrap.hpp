#pragma once

#include "uncertainty/refit.hpp"

namespace trunk {

/// What repeated fits to resampled residuals give.
struct Bootstrap {
  int repeats = 0;
  int block = 0;                     // samples
  std::vector<Interval> interval95;  // [asked for], percentiles, natural units
  Interval ratio95;                  // of k_muscle / k_elasticity; 0, 0 where k_muscle is not free
};

/// Moving-block bootstrap of the residuals (Kunsch 1989): blocks of 3 / (1 - rho) samples, 5 to a quarter of
/// the curve, keep the correlation of neighbours (our choice of length). Each repeat is fitted anew from the
/// best point.
Bootstrap bootstrap(Objective& objective, const LocalFit& fit, int repeats, unsigned seed);

}  // namespace trunk
