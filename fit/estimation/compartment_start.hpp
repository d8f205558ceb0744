#pragma once

#include <optional>

#include "compartment/compartment_model.hpp"
#include "estimation/nuisance.hpp"

namespace trunk {

/// One local search: where it began and ended.
struct LocalSearch {
  Candidate from, to;
  double objective = 0.0;
  bool converged = false;
};

/// What a compartment is fitted to, and with which parameters.
struct CompartmentFit {
  const TrunkAsCompartment& compartment;
  const TimeGrid& grid;
  const MeasuredCurve& measured;
  std::vector<std::string> names, beside;  // see SearchSpace
  std::vector<Prior> priors;
  Knowledge knowledge = {};
  std::optional<double> recoil_s = {};  // k_elasticity is held at this recoil time, if it is a name
  bool begin_at_usual_recoil = true;    // otherwise at that of the candidate
  double correlation = 0.0;             // of neighbouring samples
  int starts = 12;
  unsigned seed = 1;
};

/// Returns the priors, and none for the times and the level that have no prior of their own: straight lines
/// determine them, and a usual prior would only widen the intervals.
std::vector<Prior> priors_of_straight_lines(std::vector<Prior> priors,
                                            const std::vector<std::string>& beside);

/// Searches the compartment's log-posterior from several starts and returns the searches, the best one first.
/// The first start is `begin`. The others spread the timing of the activation, and the recoil time if it is
/// not held, over what a breath of this length allows (a Sobol sequence): the timing has local optima, of
/// which a single start misses the best one in 5 of 40 breaths, and twelve starts in none (see
/// test_estimate.cpp).
std::vector<LocalSearch> compartment_searches(const CompartmentFit& fit, const Candidate& begin);

}  // namespace trunk
