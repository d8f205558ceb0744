#pragma once

#include <utility>

#include "prediction/predicted.hpp"
#include "problem/trunk_model.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// What the subject's trunk would do in another scenario.
struct Prediction {
  std::string scenario;  // its file
  /// The measures of `simulate --json`; then own_delta_v_ml, the tidal volume in the scenario of the fit, and
  /// ratio_percent, of the two volumes draw by draw: what both share cancels.
  std::vector<Predicted> numbers;
  std::vector<double> delta_v_draws_m3, own_draws_m3;  // [draws]; NaN if the simulation failed
  int failed = 0;         // draws of which one of the two simulations did not complete
  Structure structure{};  // of the structural intervals; empty if they were not asked for
};

/// Where candidates are simulated. What it refers to must outlive it.
struct BreathingTrunk {
  const Trunk& trunk;
  const TimeGrid& grid;
};

/// Candidates in one scenario: the best one, then draws.
struct Drawn {
  BreathingTrunk at;
  std::vector<Candidate> candidates;
};

/// Returns the draws as they breathe in a scenario. What `settings` say holds for every draw, as --set
/// overrides the fit.
std::vector<Candidate> draws_in(const ScenarioFile& file, const std::vector<Candidate>& draws,
                                const std::vector<Setting>& settings);

/// Simulates candidates in the subject's own scenario and in others, which have as many. Intervals are
/// percentiles of the draws, so they cover what the fit's intervals cover, and not the error of the model.
/// Throws Cancelled.
std::vector<Prediction> predict(const Drawn& own, const std::vector<std::pair<std::string, Drawn>>& others,
                                const Execution& execution);

}  // namespace trunk
