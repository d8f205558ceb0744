#pragma once

#include "subject/subject_fit.hpp"

namespace trunk {

/// A number at the best estimate, and its median and interval over draws of the parameters. NaN: not known.
struct Predicted {
  double value = 0.0, median = 0.0, lower95 = 0.0, upper95 = 0.0;
};

/// What the subject's trunk would do in another scenario.
struct Prediction {
  std::string scenario;                                // its file
  Predicted delta_v_m3;                                // tidal volume there
  Predicted own_m3;                                    // tidal volume in the scenario of the fit
  Predicted ratio;                                     // of the two, draw by draw: what both share cancels
  std::vector<double> delta_v_draws_m3, own_draws_m3;  // [draws]; NaN if the simulation failed
  int failed = 0;  // draws of which one of the two simulations did not complete
};

/// A scenario to predict, with its trunk.
struct OtherScenario {
  ScenarioFile file;
  Trunk trunk;
};

/// Reads a scenario and makes it breathe as the subject does: the parameters, the activation and the duration
/// are those of the fit; paralysis, loads and everything else its own. `settings` go over it as over the
/// fit's. Throws InputError.
OtherScenario other_scenario(const SubjectFit& fit, const std::filesystem::path& path,
                             const std::vector<std::string>& settings);

/// Whether its trunk has the shape of the subject's.
bool same_geometry(const SubjectFit& fit, const OtherScenario& other);

/// Carries the uncertainty of a fit through to other scenarios. Parameters are drawn from Student's t around
/// the best point, with the covariance and freedom of the intervals (a shifted Sobol sequence, our choice:
/// smoother percentiles than random numbers give), kept within the bounds, and simulated in every scenario.
/// No draws where the fit has no covariance, or none are asked for. The interval covers what the fit covers:
/// the noise of the trace, not the error of the model. Throws Cancelled.
std::vector<Prediction> predict(const SubjectFit& fit, const Estimation& e,
                                const std::vector<OtherScenario>& others, int draws);

}  // namespace trunk
