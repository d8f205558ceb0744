#include "prediction/predicted.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace trunk {

Predicted predicted(const std::string& name, const std::string& unit, const std::vector<double>& values) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t fewest_draws = 16;  // fewer give no percentile of 2.5 % (our choice)
  Predicted p{name, unit, values.front(), unknown, unknown, unknown};
  std::vector<double> sorted;
  std::copy_if(values.begin() + 1, values.end(), std::back_inserter(sorted),
               [](double v) { return std::isfinite(v); });
  if (sorted.size() < fewest_draws) return p;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double part) {
    return gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), part);
  };
  p.median = at(0.5);
  p.lower95 = at(0.025);
  p.upper95 = at(0.975);
  return p;
}

std::vector<Predicted> predicted_measures(const std::vector<std::vector<NamedValue>>& rows) {
  std::vector<Predicted> all;
  for (std::size_t m = 0; m < rows.front().size(); ++m) {
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row[m].value);
    all.push_back(predicted(rows.front()[m].name, rows.front()[m].unit, values));
  }
  return all;
}

std::vector<NamedValue> intervals_of(const std::vector<Predicted>& numbers, int failed_draws) {
  std::vector<NamedValue> ends;
  for (const Predicted& p : numbers) {
    ends.push_back({p.name + "_lower95", p.unit, p.lower95});
    ends.push_back({p.name + "_upper95", p.unit, p.upper95});
  }
  ends.push_back({"failed_draws", "1", static_cast<double>(failed_draws)});
  return ends;
}

std::vector<NamedValue> structural_intervals_of(const std::vector<Predicted>& numbers) {
  std::vector<NamedValue> ends;
  for (const Predicted& p : numbers) {
    ends.push_back({p.name + "_structural_lower95", p.unit, p.structural_lower95});
    ends.push_back({p.name + "_structural_upper95", p.unit, p.structural_upper95});
  }
  return ends;
}

}  // namespace trunk
