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

/// Reads a scenario and makes it breathe as the subject does: parameters, activation and duration are those
/// of the fit; paralysis, loads and everything else are its own. `settings` are put over it as over the
/// scenario of the fit. Throws InputError.
OtherScenario other_scenario(const SubjectFit& fit, const std::filesystem::path& path,
                             const std::vector<std::string>& settings);

/// Returns whether the other trunk has the shape of the subject's at rest, to a micrometre.
bool same_geometry(const SubjectFit& fit, const OtherScenario& other);

/// Simulates other scenarios with the fitted parameters, and with draws of them to carry the uncertainty
/// along. Parameters are drawn from Student's t around the best point, with the covariance and the degrees of
/// freedom of the fit's intervals (a shifted Sobol sequence, our choice: its percentiles are smoother than
/// those of random numbers), kept within the bounds. There are no draws if the fit has no covariance or
/// `draws` is 0. The interval covers what the fit's intervals cover: the noise of the trace, not the error of
/// the model. Throws Cancelled.
std::vector<Prediction> predict(const SubjectFit& fit, const Estimation& e,
                                const std::vector<OtherScenario>& others, int draws);

}  // namespace trunk
