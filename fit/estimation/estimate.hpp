#pragma once

#include <optional>

#include "estimation/compartment_start.hpp"
#include "estimation/fit_problem.hpp"
#include "estimation/quality.hpp"
#include "search/minimise.hpp"
#include "uncertainty/bootstrap.hpp"
#include "uncertainty/likelihood_surface.hpp"

namespace trunk {

/// What an estimation computes, and how.
struct EstimationOptions {
  SearchOptions search{.algorithm = ""};  // algorithm empty: bobyqa for up to 4 parameters, else lm
  Loss loss = Loss::squares;
  bool profiles = true;
  int surface_points = 21;  // along each of two parameters; 0: no surface
  int bootstrap = 0;        // repeats
  Execution execution;
};

/// The comparison of two methods: where a search of NLopt ended, and where a Gauss-Newton step would go from
/// there. Both move the nuisance parameters along.
struct CrossCheck {
  std::string first, second;
  Eigen::VectorXd difference;  // [mechanical parameters asked for] in coordinates, which are about relative
  bool agree = false;          // each within 0.1 standard errors or 2e-3; wider for several observables

  double largest_difference() const { return difference.cwiseAbs().maxCoeff(); }
};

/// The outcome of fitting one breath.
struct Estimation {
  SearchResult search;
  std::string algorithm;  // of the search on the trunk
  std::optional<CrossCheck> cross_check;
  std::optional<Uncertainty> uncertainty;  // none if the search did not converge
  std::optional<LocalFit> local;
  std::vector<Profile> profiles;
  std::optional<LikelihoodSurface> surface;
  std::optional<Bootstrap> bootstrap;
  std::vector<std::string> notes;  // what was left out, and why
  Candidate best;
  Eigen::VectorXd model;  // [values] the volume, then what is beside it; empty if the best simulation failed
  Quality quality;
  std::vector<Evaluation> evaluations;
  int failures = 0;
  std::size_t simulations = 0;  // of the trunk, during the search
  std::size_t simulated = 0;    // of those, the ones that were not in the ledger
};

/// Fits the parameters of the problem's space. A breath is fitted in these steps: the compartment, which is
/// already at its best point at the start of the space, is corrected by what it misses there and searched
/// again, until nothing changes; then NLopt searches the mechanical parameters asked for on the trunk itself,
/// with all others moving along (see WithoutNuisance). A tidal volume alone is met by a search on the trunk.
/// Intervals, profiles and the joint region come from the corrected compartment. Throws InputError if the
/// curve is empty or longer than the grid, and Cancelled once the execution is cancelled. A search that fails
/// is reported in the result.
Estimation estimate(const FitProblem& problem, const EstimationOptions& options, Ledger& ledger);

}  // namespace trunk
