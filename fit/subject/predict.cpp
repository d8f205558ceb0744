#include "subject/predict.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "math/units.hpp"
#include "parallel/workers.hpp"
#include "records/run_record.hpp"
#include "records/stored_subject.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_draws = 16;  // fewer give no percentile of 2.5 % (our choice)

using Row = std::vector<NamedValue>;  // the measures of one candidate

/// Returns the measures of every candidate in every place: [places][candidates].
std::vector<std::vector<Row>> simulated(const std::vector<const Drawn*>& places, const Execution& execution) {
  const std::size_t together = batch_lanes(), count = places.front()->candidates.size();
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < count; i += together) firsts.push_back(i);
  std::vector<std::vector<Row>> rows(places.size(), std::vector<Row>(count));
  const auto cancelled = [&] { return execution.cancelled && execution.cancelled(); };
  using Part = std::pair<std::size_t, std::vector<std::vector<Row>>>;
  work_off<Part>(
      firsts, execution.threads, cancelled,
      [&](std::size_t first) {
        Part part{first, {}};
        for (const Drawn* place : places) {
          const auto some = std::span(place->candidates).subspan(first, std::min(together, count - first));
          part.second.emplace_back();
          for (const BreathSummary& breath : summarise_breaths(place->at.trunk, some, place->at.grid))
            part.second.back().push_back(measures_of(breath));
        }
        return part;
      },
      [&](Part part) {
        for (std::size_t k = 0; k < places.size(); ++k)
          std::move(part.second[k].begin(), part.second[k].end(),
                    rows[k].begin() + static_cast<std::ptrdiff_t>(part.first));
      });
  if (cancelled()) throw Cancelled();
  return rows;
}

/// Returns one measure of all candidates.
std::vector<double> column(const std::vector<Row>& rows, std::size_t measure) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row[measure].value);
  return values;
}

/// Returns all values but the first, which belongs to the best candidate.
std::vector<double> draws_of(const std::vector<double>& values) {
  return {values.begin() + 1, values.end()};
}

std::vector<double> volumes_m3(std::vector<double> volumes_ml) {
  for (double& v : volumes_ml) v *= m3_per_ml;
  return volumes_ml;
}

Predicted predicted(const std::string& name, const std::string& unit, const std::vector<double>& values) {
  Predicted p{name, unit, values.front(), unknown, unknown, unknown};
  std::vector<double> sorted;
  for (const double v : draws_of(values))
    if (std::isfinite(v)) sorted.push_back(v);
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

}  // namespace

OtherScenario other_scenario(const SubjectFit& fit, const std::filesystem::path& path,
                             const std::vector<std::string>& settings) {
  ScenarioFile file = read_scenario(path, settings);
  breathe_as(fit.file().scenario, file.scenario);
  Trunk trunk = build_timed_trunk(file, stiffer_in_searches);
  return {std::move(file), std::move(trunk)};
}

bool same_geometry(const SubjectFit& fit, const OtherScenario& other) {
  const auto& a = fit.trunk().mesh.rest;
  const auto& b = other.trunk.mesh.rest;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec3d& p, const Vec3d& q) { return dot(p - q, p - q) < 1e-12; });
}

std::vector<Prediction> predict(const Drawn& own, const std::vector<std::pair<std::string, Drawn>>& others,
                                const Execution& execution) {
  if (others.empty()) return {};
  std::vector<const Drawn*> places = {&own};
  for (const auto& [name, drawn] : others) places.push_back(&drawn);
  const auto rows = simulated(places, execution);

  std::vector<Prediction> result;
  const std::vector<double> own_ml = column(rows.front(), 0);
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::vector<Row>& theirs = rows[k + 1];
    const std::vector<double> ml = column(theirs, 0);
    std::vector<double> percent;
    for (std::size_t i = 0; i < ml.size(); ++i) percent.push_back(100.0 * ml[i] / own_ml[i]);
    Prediction p{others[k].first, {}, volumes_m3(draws_of(ml)), volumes_m3(draws_of(own_ml)), 0};
    for (std::size_t m = 0; m < theirs.front().size(); ++m)
      p.numbers.push_back(predicted(theirs.front()[m].name, theirs.front()[m].unit, column(theirs, m)));
    p.numbers.push_back(predicted("own_delta_v_ml", "ml", own_ml));
    p.numbers.push_back(predicted("ratio_percent", "percent", percent));
    p.failed = static_cast<int>(
        std::count_if(percent.begin() + 1, percent.end(), [](double v) { return !std::isfinite(v); }));
    result.push_back(std::move(p));
  }
  return result;
}

}  // namespace trunk
