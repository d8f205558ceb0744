#pragma once

#include <span>
#include <vector>

namespace trunk {

/// How a number changes as one choice goes to the ends of its range, or to the other one of two values.
struct Effect {
  double low, high;  // of one of two: the other is `high`, and `low` is not used
  bool one_of_two = false;

  /// Returns the variance of the change over the range.
  double variance() const noexcept;
  /// Returns the change at a place from -1 to 1.
  double at(double place) const noexcept;
};

/// What two choices do together beyond the sum of both, per product of their places.
struct Crossing {
  std::size_t first, second;
  double bend;
};

/// What several choices do together.
struct Mixture {
  double lower95, upper95;     // of the whole change
  std::vector<double> shares;  // [effects] of the variance; they add to 1, and are NaN if nothing changes
};

/// Returns the interval that holds 95 % of the changes over all combinations of choices, and the share of
/// each choice.
///
/// A choice has a place u from -1 to 1, all as probable, and changes the number along a parabola through both
/// ends and 0 in between; or it is one of two values, each as probable. A crossing adds `bend` u v. All these
/// parts are uncorrelated, so the variance is the sum of theirs; half of that of a crossing is counted to
/// each of its choices (the Shapley share; Owen 2014). The percentiles are those of 4096 points of a Sobol
/// sequence. A change that is not known makes all unknown.
Mixture mixture_of(std::span<const Effect> effects, std::span<const Crossing> crossings);

}  // namespace trunk
