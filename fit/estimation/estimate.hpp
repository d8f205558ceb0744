#pragma once

#include <optional>

#include "estimation/quality.hpp"
#include "estimation/start.hpp"
#include "search/minimise.hpp"
#include "uncertainty/bootstrap.hpp"
#include "uncertainty/likelihood_surface.hpp"

namespace trunk {

/// What is asked of an estimation.
struct EstimationOptions {
  SearchOptions search{.algorithm = ""};  // algorithm empty: bobyqa for up to 4 parameters, else lm
  int starts = 1;                         // the scenario's own, the others spread over the bounds (Sobol)
  Loss loss = Loss::squares;
  bool cross_check = true;  // a second search by another method
  bool profiles = true;
  int surface_points = 11;  // along each of two parameters; 0: no surface
  int bootstrap = 0;        // repeats
  double budget_s = 10.0;   // profiles and surface are left out where each would take longer on two cores
  Execution execution;
};

/// One local search, and where it ended.
struct LocalSearch {
  Eigen::VectorXd from, to;
  double objective = 0.0;
  bool converged = false;
};

/// Two methods side by side: one without derivatives over the mechanical parameters, Levenberg-Marquardt over
/// everything.
struct CrossCheck {
  std::string first, second;
  double largest_difference = 0.0;  // in coordinates: relative
  bool agree = false;               // within 0.1 standard errors or 1e-4
};

/// The outcome of analysis by synthesis for one breath.
struct Estimation {
  SearchResult search;
  std::string algorithm;  // of the first search
  std::vector<LocalSearch> starts;
  std::optional<CrossCheck> cross_check;
  std::optional<Uncertainty> uncertainty;  // none where the search found nothing to stand on
  std::optional<LocalFit> local;
  std::vector<Profile> profiles;
  std::optional<LikelihoodSurface> surface;
  std::optional<Bootstrap> bootstrap;
  std::vector<std::string> notes;  // what was left out, and why
  Candidate best;
  Eigen::VectorXd model;  // at the measured samples, m3; empty where no simulation completed
  Quality quality;
  std::vector<Evaluation> evaluations;
  int failures = 0;
  std::size_t simulated = 0;  // of the evaluations, not counting what the ledger knew
};

/// Fits the parameters of `space` to `measured`: starts at the measured tidal volume, local searches over
/// what was asked for, Levenberg-Marquardt over everything from the best, a second search without derivatives
/// as a check, then uncertainty. The space's start holds the activation given to the fit; `timed` numbers of
/// it were taken from the trace. Throws InputError on a measured or space that make no sense, Cancelled where
/// told to stop; a search that fails is reported in the result.
Estimation estimate(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space,
                    const MeasuredCurve& measured, const EstimationOptions& options, Ledger& ledger,
                    std::size_t timed = 0);

}  // namespace trunk
