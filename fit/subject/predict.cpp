#include "subject/predict.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "linear_algebra/decompositions.hpp"
#include "parallel/workers.hpp"
#include "scenarios/build_trunk.hpp"
#include "search/multistart.hpp"

namespace trunk {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_draws = 16;  // fewer give no percentile of 2.5 % (our choice)

/// Returns the best point, then the draws.
std::vector<Candidate> candidates_of(const SearchSpace& space, const Estimation& e, int draws,
                                     unsigned seed) {
  std::vector<Candidate> result = {e.best};
  if (!e.local) return result;
  const auto n = static_cast<Eigen::Index>(space.size());
  const SymmetricEigen eigen = symmetric_eigen(e.local->covariance);
  const Eigen::MatrixXd root = eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const double freedom = e.local->freedom;
  const LeastSquares cube{{}, Eigen::VectorXd::Zero(n + 1), Eigen::VectorXd::Ones(n + 1)};
  const Eigen::VectorXd lower = space.lower(), upper = space.upper();
  for (Eigen::VectorXd part : sobol_starts(cube, static_cast<std::size_t>(draws), seed)) {
    part = part.cwiseMax(1e-9).cwiseMin(1.0 - 1e-9);
    // The sequence is most even in its first dimensions: these go where the fit is least certain.
    const Eigen::VectorXd normal = part.head(n).unaryExpr(&gsl_cdf_ugaussian_Pinv).reverse();
    const double spread = std::sqrt(freedom / gsl_cdf_chisq_Pinv(part[n], freedom));
    const Eigen::VectorXd x = e.local->x + spread * (root * normal);
    result.push_back(space.decode(x.cwiseMax(lower).cwiseMin(upper)));
  }
  return result;
}

/// Returns the tidal volume of each candidate, m3; NaN if its simulation failed.
std::vector<double> tidal_volumes(const Trunk& trunk, std::span<const Candidate> candidates,
                                  const TimeGrid& grid) {
  std::vector<double> volumes;
  for (const VolumeCurve& curve : simulate_volumes(trunk, candidates, grid))
    volumes.push_back(curve.ending.completed() ? *std::max_element(curve.delta_v.begin(), curve.delta_v.end())
                                               : unknown);
  return volumes;
}

struct DrawAt {
  const Trunk& trunk;
  const TimeGrid& grid;
};

/// Returns the tidal volume of every candidate in every place, m3: [places][candidates].
std::vector<std::vector<double>> all_volumes(const std::vector<DrawAt>& places,
                                             const std::vector<Candidate>& candidates,
                                             const Execution& execution) {
  const std::size_t together = batch_lanes();
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < candidates.size(); i += together) firsts.push_back(i);
  std::vector<std::vector<double>> volumes(places.size(), std::vector<double>(candidates.size(), unknown));
  const auto cancelled = [&] { return execution.cancelled && execution.cancelled(); };
  using Part = std::pair<std::size_t, std::vector<std::vector<double>>>;
  work_off<Part>(
      firsts, execution.threads, cancelled,
      [&](std::size_t first) {
        const auto some = std::span(candidates).subspan(first, std::min(together, candidates.size() - first));
        Part part{first, {}};
        for (const DrawAt& s : places) part.second.push_back(tidal_volumes(s.trunk, some, s.grid));
        return part;
      },
      [&](Part part) {
        for (std::size_t k = 0; k < places.size(); ++k)
          std::copy(part.second[k].begin(), part.second[k].end(),
                    volumes[k].begin() + static_cast<std::ptrdiff_t>(part.first));
      });
  if (cancelled()) throw Cancelled();
  return volumes;
}

/// Returns all values but the first, which belongs to the best point.
std::vector<double> draws_of(const std::vector<double>& values) {
  return {values.begin() + 1, values.end()};
}

Predicted predicted(const std::vector<double>& values) {
  Predicted p{values.front(), unknown, unknown, unknown};
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
  const Scenario& own = fit.file().scenario;
  file.scenario.parameters = own.parameters;
  file.scenario.activation = own.activation;
  file.scenario.time.duration_s = own.time.duration_s;
  file.scenario.time.start = own.time.start;
  Trunk trunk = build_timed_trunk(file, stiffer_in_searches);
  return {std::move(file), std::move(trunk)};
}

bool same_geometry(const SubjectFit& fit, const OtherScenario& other) {
  const auto& a = fit.trunk().mesh.rest;
  const auto& b = other.trunk.mesh.rest;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec3d& p, const Vec3d& q) { return dot(p - q, p - q) < 1e-12; });
}

std::vector<Prediction> predict(const SubjectFit& fit, const Estimation& e,
                                const std::vector<OtherScenario>& others, int draws) {
  if (others.empty()) return {};
  const EstimationOptions& options = fit.plan().estimation;
  const std::vector<Candidate> candidates = candidates_of(fit.space(), e, draws, options.search.seed);
  std::vector<DrawAt> places = {{fit.trunk(), fit.file().scenario.time}};
  for (const OtherScenario& o : others) places.push_back({o.trunk, o.file.scenario.time});
  const auto volumes = all_volumes(places, candidates, options.execution);

  std::vector<Prediction> result;
  const std::vector<double>& own = volumes.front();
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::vector<double>& theirs = volumes[k + 1];
    std::vector<double> ratio;
    for (std::size_t i = 0; i < own.size(); ++i) ratio.push_back(theirs[i] / own[i]);
    const auto failed =
        std::count_if(ratio.begin() + 1, ratio.end(), [](double v) { return !std::isfinite(v); });
    result.push_back({others[k].file.path, predicted(theirs), predicted(own), predicted(ratio),
                      draws_of(theirs), draws_of(own), static_cast<int>(failed)});
  }
  return result;
}

}  // namespace trunk
