#pragma once

#include "problem/scale_priors.hpp"
#include "verdict/fit_results.hpp"

namespace trunk {

/// What is known of a fit when its results are graded. All that it refers to must outlive it.
struct FitEvidence {
  const FitProblem& problem;
  const Estimation& estimation;
  const MeasuredBreath* breath = nullptr;  // none if only a tidal volume was measured
  const std::vector<Gate>& gates;
  double gain_error = 0.0;    // relative error of the tidal volume, one deviation
  bool straight = false;      // --assume straight-activation
  bool energy_known = false;  // the energy law is part of the posterior
  std::optional<StraightActivation> straight_lines{};
  std::vector<LocalSearch> optima{};  // of the compartment, best first
  std::vector<ScalePrior> scale{};    // priors on forces; empty: volume alone, and no lung
  bool airway_driven = false;         // the recorded pressure of the airway drives the breath
};

/// Returns the results of a fit: values, intervals, grades and reasons (thresholds: our choice).
///
/// The recoil time comes from the energy law, unless the activation is assumed to be straight. All that goes
/// with it is fitted again at both ends of its interval, and what that changes is added to the spread of
/// breaths and noise as the root of the sum of squares. Measures of the trunk are simulated at these three
/// points and at a volume that is 5 % larger.
FitResults assess_fit(const FitEvidence& evidence);

}  // namespace trunk
