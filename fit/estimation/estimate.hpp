#pragma once

#include <optional>

#include "estimation/quality.hpp"
#include "estimation/start.hpp"
#include "search/minimise.hpp"
#include "uncertainty/bootstrap.hpp"
#include "uncertainty/likelihood_surface.hpp"

namespace trunk {

/// What an estimation computes, and how.
struct EstimationOptions {
  SearchOptions search{.algorithm = ""};  // algorithm empty: bobyqa for up to 4 parameters, else lm
  int starts = 1;                         // the first from the scenario, the others from a Sobol sequence
  Loss loss = Loss::squares;
  bool cross_check = true;  // a second search by another method
  bool profiles = true;
  int surface_points = 11;  // along each of two parameters; 0: no surface
  int bootstrap = 0;        // repeats
  double budget_s = 10.0;   // profiles or surface are left out if they would take longer on two cores
  Execution execution;
};

/// One local search: where it began and ended.
struct LocalSearch {
  Eigen::VectorXd from, to;
  double objective = 0.0;
  bool converged = false;
};

/// The comparison of two methods: one without derivatives over the mechanical parameters, and
/// Levenberg-Marquardt over all parameters.
struct CrossCheck {
  std::string first, second;
  double largest_difference = 0.0;  // in coordinates, which are about relative
  bool agree = false;               // within 0.1 standard errors or 1e-4
};

/// The outcome of fitting one breath.
struct Estimation {
  SearchResult search;
  std::string algorithm;  // of the first search
  std::vector<LocalSearch> starts;
  std::optional<CrossCheck> cross_check;
  std::optional<Uncertainty> uncertainty;  // none if the search did not converge
  std::optional<LocalFit> local;
  std::vector<Profile> profiles;
  std::optional<LikelihoodSurface> surface;
  std::optional<Bootstrap> bootstrap;
  std::vector<std::string> notes;  // what was left out, and why
  Candidate best;
  Eigen::VectorXd model;  // at the measured samples, m3; empty if the best simulation failed
  Quality quality;
  std::vector<Evaluation> evaluations;
  int failures = 0;
  std::size_t simulated = 0;  // evaluations that were not in the ledger
};

/// Fits the parameters of `space` to `measured`. The steps are: a start at the measured tidal volume,
/// local searches over the parameters asked for, Levenberg-Marquardt over all parameters from the best point,
/// a second search without derivatives as a check, and the uncertainty. The start of the space holds the
/// activation; `timed` of its numbers were read from the trace. Throws InputError if the curve is empty or
/// longer than the grid, and Cancelled once the execution is cancelled. A search that fails is reported in
/// the result.
Estimation estimate(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space,
                    const MeasuredCurve& measured, const EstimationOptions& options, Ledger& ledger,
                    std::size_t timed = 0);

}  // namespace trunk
