#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// Numbers are the same where they are apart by no more than `absolute`, or by `relative` of the larger one;
/// a curve's larger one is its own highest absolute value. Our choice: below what any reader sees in a
/// number.
struct Tolerance {
  double relative = 1e-6;
  double absolute = 1e-9;  // in the unit of the number
};

/// Something that is not the same in two files. `note` says what where it is not a number.
struct Difference {
  std::string group, name, unit;
  double first = 0.0, second = 0.0;
  std::optional<double> time_s;  // where curves are farthest apart
  std::string note;
};

/// What was compared, and what of it differs; NaN equals NaN.
struct Comparison {
  std::size_t compared = 0;  // numbers, texts and curves
  double farthest_m = 0.0;   // particles apart, where both have a trajectory of the same particles
  std::vector<Difference> differences;

  bool same() const noexcept { return differences.empty(); }
};

/// Status, parameters, measures, curves, and the trajectory at the moments both have. Clock times are left
/// out.
Comparison compare_runs(const RunRecord& first, const RunRecord& second, const Tolerance& tolerance);

/// Status, the table of parameters with intervals, statistics, measured and fitted curve, and the best runs.
Comparison compare_fits(const FitRecord& first, const FitRecord& second, const Tolerance& tolerance);

}  // namespace trunk
