#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// Two numbers are the same if they differ by at most `absolute`, or by at most `relative` times the larger
/// one. For curves the larger one is the highest absolute value of the curve. The defaults (our choice) are
/// too small for a reader to see.
struct Tolerance {
  double relative = 1e-6;
  double absolute = 1e-9;  // in the unit of the number
};

/// A difference between two files. `note` describes a difference that is not one of numbers.
struct Difference {
  std::string group, name, unit;
  double first = 0.0, second = 0.0;
  std::optional<double> time_s;  // when two curves differ most
  std::string note;
};

/// The outcome of a comparison; NaN equals NaN.
struct Comparison {
  std::size_t compared = 0;  // numbers, texts and curves
  double farthest_m =
      0.0;  // largest distance of a coordinate, if both have a trajectory of the same particles
  std::vector<Difference> differences;

  bool same() const noexcept { return differences.empty(); }
};

/// Compares status, parameters, measures, curves, and the trajectories at the times that both have. Clock
/// times are not compared.
Comparison compare_runs(const RunRecord& first, const RunRecord& second, const Tolerance& tolerance);

/// Compares status, parameters with intervals, statistics, measured and fitted curves, and the best runs.
Comparison compare_fits(const FitRecord& first, const FitRecord& second, const Tolerance& tolerance);

}  // namespace trunk
