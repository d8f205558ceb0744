#pragma once

#include "subject/subject_fit.hpp"

namespace trunk {

/// A number at the best estimate, and its median and interval over draws of the parameters. NaN: not known.
struct Predicted {
  std::string name, unit;
  double value = 0.0, median = 0.0, lower95 = 0.0, upper95 = 0.0;
};

/// What the subject's trunk would do in another scenario.
struct Prediction {
  std::string scenario;  // its file
  /// The measures of `simulate --json`; then own_delta_v_ml, the tidal volume in the scenario of the fit, and
  /// ratio_percent, of the two volumes draw by draw: what both share cancels.
  std::vector<Predicted> numbers;
  std::vector<double> delta_v_draws_m3, own_draws_m3;  // [draws]; NaN if the simulation failed
  int failed = 0;  // draws of which one of the two simulations did not complete
};

/// A scenario to predict, with its trunk.
struct OtherScenario {
  ScenarioFile file;
  Trunk trunk;
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

/// Reads a scenario and makes it breathe as the subject does: parameters, activation, duration and start are
/// those of the fit; paralysis, loads and everything else are its own. `settings` are put over it as over the
/// scenario of the fit. Throws InputError.
OtherScenario other_scenario(const SubjectFit& fit, const std::filesystem::path& path,
                             const std::vector<std::string>& settings);

/// Returns whether the other trunk has the shape of the subject's at rest, to a micrometre.
bool same_geometry(const SubjectFit& fit, const OtherScenario& other);

/// Simulates candidates in the subject's own scenario and in others, which have as many. Intervals are
/// percentiles of the draws, so they cover what the fit's intervals cover, and not the error of the model.
/// With fewer than 16 draws there are none. Throws Cancelled.
std::vector<Prediction> predict(const Drawn& own, const std::vector<std::pair<std::string, Drawn>>& others,
                                const Execution& execution);

}  // namespace trunk
