#pragma once

#include <limits>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// A number at the best estimate, and its median and interval over draws of the parameters. NaN: not known.
struct Predicted {
  std::string name, unit;
  double value = 0.0, median = 0.0, lower95 = 0.0, upper95 = 0.0;
  double structural_lower95 = std::numeric_limits<double>::quiet_NaN();  // over choices of the model
  double structural_upper95 = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the first value, which belongs to the best estimate, with percentiles of all others, which belong
/// to draws. Values that are not finite are left out. With fewer than 16 draws there is no interval.
Predicted predicted(const std::string& name, const std::string& unit, const std::vector<double>& values);

/// Returns every measure over rows of measures: the row of the best estimate, then those of draws.
std::vector<Predicted> predicted_measures(const std::vector<std::vector<NamedValue>>& rows);

/// Returns both ends of each interval, called X_lower95 and X_upper95 for a number X, then failed_draws, the
/// count of draws that did not complete.
std::vector<NamedValue> intervals_of(const std::vector<Predicted>& numbers, int failed_draws);

/// Returns both ends of each structural interval, called X_structural_lower95 and X_structural_upper95.
std::vector<NamedValue> structural_intervals_of(const std::vector<Predicted>& numbers);

}  // namespace trunk
