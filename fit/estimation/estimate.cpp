#include "estimation/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/search_breath.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_without_derivatives = 4;

std::string algorithm_of(const FitProblem& problem, const EstimationOptions& options) {
  if (!options.search.algorithm.empty()) return options.search.algorithm;
  const bool many = problem.space.asked_for() > most_without_derivatives;
  return many || problem.measured.is_tidal_volume() ? "lm" : "bobyqa";
}

/// Meets one number by one parameter or more.
void search_tidal_volume(Objective& trunk, const EstimationOptions& options, Estimation& e) {
  SearchOptions search = options.search;
  search.algorithm = e.algorithm;
  const LeastSquares problem = trunk.problem();
  e.search = minimise(problem, start_at_tidal_volume(trunk, trunk.space().start()), search);
  if (e.search.converged && e.algorithm != "lm") {
    search.algorithm = "lm";
    e.search = minimise(problem, e.search.best, search);
  }
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

void add_uncertainty(const FitProblem& problem, Objective& compartment, const EstimationOptions& options,
                     Estimation& e) {
  e.local = local_fit(compartment, e.search.best, e.model, problem.breaths);
  if (!e.local) {
    e.notes.push_back("no uncertainty: the compartment has no slopes at the best point");
    return;
  }
  e.uncertainty = assess(compartment, *e.local);
  if (e.cross_check && !e.cross_check->agree) {
    const Eigen::VectorXd deviation = e.local->covariance.diagonal().cwiseSqrt();
    // Simulations repeat to about 1e-4 of the tidal volume. Where several observables weigh that much, the
    // flattest direction is known to half a standard error only.
    const bool several = compartment.blocks().size() > 1 || problem.compartment.airway_drives();
    const double part = several ? 0.5 : 0.1;
    const Eigen::VectorXd allowed = part * deviation(mechanical_asked_for(problem.space));
    e.cross_check->agree = (e.cross_check->difference.cwiseAbs().array() <= allowed.array()).all();
  }
  if (options.profiles) e.profiles = profiles(compartment, *e.local);
  apply_profiles(e.profiles, options.loss, *e.uncertainty);
  if (options.surface_points > 0 && problem.space.asked_for() == 2)
    e.surface = likelihood_surface(compartment, *e.local, options.surface_points);
  if (options.bootstrap > 0)
    e.bootstrap = bootstrap(compartment, *e.local, options.bootstrap, options.search.seed);
}

}  // namespace

Estimation estimate(const FitProblem& p, const EstimationOptions& options, Ledger& ledger) {
  TrunkModel simulations(p.trunk, p.grid, p.measured, ledger, options.execution);
  CompartmentModel stand_in(p.compartment, p.grid, p.measured);
  Objective trunk(simulations, p.grid, p.space, p.measured, p.knowledge),
      compartment(stand_in, p.grid, p.space, p.measured, p.knowledge);
  trunk.use_correlation(p.correlation);
  compartment.use_correlation(p.correlation);
  Estimation e;
  e.algorithm = algorithm_of(p, options);
  const bool one_number = p.measured.is_tidal_volume();
  if (one_number)
    search_tidal_volume(trunk, options, e);
  else
    search_breath(trunk, compartment, stand_in, p.begin, options, e);
  e.simulations = trunk.evaluations().size();
  if (const auto model = trunk.model(e.search.best)) {
    e.best = p.space.decode(e.search.best);
    e.model = *model;
    e.quality = quality_of(p.measured, e.model.head(trunk.blocks().front().count), p.space.size(), p.grid,
                           e.best.activation);
    if (one_number)
      e.uncertainty = without_uncertainty(trunk, e.search.best);
    else if (e.search.converged)
      add_uncertainty(p, compartment, options, e);
  }
  e.evaluations = trunk.evaluations();
  e.failures = trunk.failures();
  e.simulated = simulations.simulated();
  return e;
}

}  // namespace trunk
