#include "estimation/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include "search/multistart.hpp"

namespace trunk {
namespace {

constexpr double coarse = 1e-3;        // tolerance of a first search: another one follows
constexpr double close_enough = 1e-4;  // in coordinates, between two methods
constexpr std::size_t most_without_derivatives = 4;

using Indices = std::vector<Eigen::Index>;

Indices first_ones(std::size_t count) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), Eigen::Index{0});
  return indices;
}

/// Returns the mechanical parameters asked for: few enough for a method without derivatives.
Indices mechanical(const SearchSpace& space) {
  Indices indices;
  for (std::size_t i = 0; i < space.asked_for(); ++i)
    if (space.parameter(i).group == FreeParameter::Group::mechanics)
      indices.push_back(static_cast<Eigen::Index>(i));
  return indices;
}

class Fitting {
 public:
  Fitting(Objective& objective, const EstimationOptions& options, Estimation& result)
      : objective_(objective),
        space_(objective.space()),
        options_(options),
        result_(result),
        problem_(objective.problem()) {
    // By default use differences: side by side in lanes on all cores they take a third of the time.
    if (options.search.algorithm.empty()) problem_.exact_slopes = nullptr;
    if (options.search.algorithm.empty())
      result.algorithm =
          space_.asked_for() > most_without_derivatives || objective.measured_curve().is_tidal_volume()
              ? "lm"
              : "bobyqa";
    else
      result.algorithm = options.search.algorithm;
  }

  void run() {
    search_from_starts();
    if (!result_.search.converged) return;
    finish();
    if (options_.loss == Loss::squares) return;
    const Eigen::VectorXd residuals = residuals_at(result_.search.best);
    objective_.use_loss(options_.loss, std::max(median_deviation(residuals), 1e-9));
    result_.search.objective = problem_.at(result_.search.best).objective;
    finish();
  }

 private:
  Eigen::VectorXd residuals_at(const Eigen::VectorXd& x) {
    return (*objective_.model(x) - objective_.measured()).cwiseQuotient(objective_.deviation());
  }

  /// Searches over the `free` coordinates; the others keep their values in `at`. The result has all of them.
  SearchResult search(const Indices& free, const Eigen::VectorXd& at, const Eigen::VectorXd& from,
                      const SearchOptions& options) {
    const LeastSquares part = with_fixed(problem_, at, free);
    SearchResult found = minimise(part, from(free), options);
    Eigen::VectorXd all = at;
    all(free) = found.best;
    found.best = all;
    return found;
  }

  void search_from_starts() {
    SearchOptions options = options_.search;
    options.algorithm = result_.algorithm;
    if (!objective_.measured_curve().is_tidal_volume())
      options.coordinate_tolerance = std::max(coarse, options.coordinate_tolerance);
    const Indices asked_for = first_ones(space_.asked_for());
    std::vector<Eigen::VectorXd> starts = {space_.start()};
    const LeastSquares part = with_fixed(problem_, starts[0], asked_for);
    for (const Eigen::VectorXd& x :
         sobol_starts(part, static_cast<std::size_t>(options_.starts - 1), options.seed)) {
      starts.push_back(starts[0]);
      starts.back()(asked_for) = x;
    }
    for (const Eigen::VectorXd& start : starts) {
      const Eigen::VectorXd near = start_at_tidal_volume(objective_, start);
      const SearchResult found = search(asked_for, near, near, options);
      result_.starts.push_back({start, found.best, found.objective, found.converged});
      if (result_.starts.size() == 1 || found.objective < result_.search.objective) result_.search = found;
    }
  }

  /// Goes from a coarse optimum to the best point by two methods.
  void finish() {
    const Eigen::VectorXd coarse_best = result_.search.best;
    if (result_.algorithm != "lm" || space_.size() > space_.asked_for() || options_.loss != Loss::squares) {
      adopt(levenberg_marquardt(problem_, coarse_best, finisher()));
    }
    const Indices some = mechanical(space_);
    if (!options_.cross_check || some.empty() || objective_.measured_curve().is_tidal_volume()) return;
    SearchOptions options = options_.search;
    options.algorithm = result_.algorithm == "lm" ? "bobyqa" : result_.algorithm;
    options.first_step = 0.05;
    const Eigen::VectorXd by_lm = result_.search.best;
    const SearchResult check = search(some, by_lm, coarse_best, options);
    const double apart = (check.best - by_lm).cwiseAbs().maxCoeff();
    result_.cross_check = {options.algorithm, "lm", apart, apart <= close_enough};
    if (check.objective < result_.search.objective * (1.0 - 1e-6)) {
      adopt(check);
      adopt(levenberg_marquardt(problem_, check.best, finisher()));
    }
  }

  SearchOptions finisher() const {
    SearchOptions lm = options_.search;
    lm.max_evaluations *= 1 + static_cast<int>(space_.size()) / 2;
    lm.objective_tolerance =
        std::max(lm.objective_tolerance, space_.size() > space_.asked_for() ? 1e-5 : 1e-10);
    return lm;
  }

  void adopt(SearchResult found) {
    if (found.objective > result_.search.objective) {
      found.best = result_.search.best;
      found.objective = result_.search.objective;
    }
    result_.search = std::move(found);
  }

  Objective& objective_;
  const SearchSpace& space_;
  const EstimationOptions& options_;
  Estimation& result_;
  LeastSquares problem_;
};

/// Returns about how long simulations take on an ordinary machine. It depends only on the problem, so the
/// same fit always has the same parts (our choice: 60 ns per particle and step, two cores).
double seconds_for(std::size_t simulations, std::size_t particles, int steps) {
  return 0.5 * 60e-9 * static_cast<double>(particles) * steps * static_cast<double>(simulations);
}

/// A parameter whose profile is open is not identifiable, whatever the interval of the linear model is.
/// Profiles under a robust loss are too flat for this conclusion.
void apply_profiles(const std::vector<Profile>& profiles, Loss loss, Uncertainty& u) {
  if (loss != Loss::squares || profiles.empty()) return;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const Interval& range = profiles[i].interval95;
    if (std::isfinite(range.lower) && std::isfinite(range.upper)) continue;
    u.parameters[i].identifiable = false;
    u.parameters[i].open_profile = range;
  }
  conclude(u);
}

void add_uncertainty(Objective& objective, const EstimationOptions& options, std::size_t particles,
                     const TimeGrid& grid, Estimation& e) {
  const SearchSpace& space = objective.space();
  if (objective.samples() <= static_cast<Eigen::Index>(space.size())) {
    e.uncertainty = without_uncertainty(objective, e.search.best);
    return;
  }
  e.local = local_fit(objective, e.search.best);
  if (!e.local) {
    e.notes.push_back("no uncertainty: the simulation fails near the best point");
    return;
  }
  e.uncertainty = assess(objective, *e.local);
  if (e.cross_check && !e.cross_check->agree) {
    const double smallest = e.local->covariance.diagonal()
                                .head(static_cast<Eigen::Index>(space.asked_for()))
                                .cwiseSqrt()
                                .minCoeff();
    e.cross_check->agree = e.cross_check->largest_difference <= 0.1 * smallest;
  }
  const auto affordable = [&](std::size_t simulations, const char* what, const char* option) {
    const double needed = seconds_for(simulations, particles, grid.steps());
    if (needed <= options.budget_s) return true;
    e.notes.push_back(
        fmt::format("no {}: it would take about {:.0f} s ({} forces it)", what, needed, option));
    return false;
  };
  const int points = 4;
  if (options.profiles &&
      affordable(space.asked_for() * 3 * static_cast<std::size_t>(2 * points), "profiles", "--profiles"))
    e.profiles = profiles(objective, *e.local, points);
  apply_profiles(e.profiles, options.loss, *e.uncertainty);
  const auto side = static_cast<std::size_t>(options.surface_points);
  if (side > 0 && space.asked_for() == 2 && affordable(side * side, "likelihood surface", "--surface"))
    e.surface = likelihood_surface(objective, *e.local, options.surface_points);
  if (options.bootstrap > 0)
    e.bootstrap = bootstrap(objective, *e.local, options.bootstrap, options.search.seed);
}

}  // namespace

Estimation estimate(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space,
                    const MeasuredCurve& measured, const EstimationOptions& options, Ledger& ledger,
                    std::size_t timed) {
  Objective objective(trunk, grid, space, measured, ledger, options.execution);
  Estimation e;
  Fitting(objective, options, e).run();
  if (const auto model = objective.model(e.search.best)) {
    e.best = space.decode(e.search.best);
    e.model = *model;
    e.quality = quality_of(measured, e.model, space.size(), space.decode(space.start()).activation, timed);
    if (e.search.converged) add_uncertainty(objective, options, trunk.model.particles(), grid, e);
    if (e.uncertainty) e.uncertainty->verdict += caveat(e.quality, e.uncertainty->residual_autocorrelation);
  }
  e.evaluations = objective.evaluations();
  e.failures = objective.failures();
  e.simulated = objective.simulated();
  return e;
}

}  // namespace trunk
