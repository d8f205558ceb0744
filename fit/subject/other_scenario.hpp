#pragma once

#include "subject/subject_fit.hpp"

namespace trunk {

/// A scenario to predict, with its trunk.
struct OtherScenario {
  ScenarioFile file;
  Trunk trunk;
};

/// Reads a scenario and makes it breathe as the subject does: parameters, activation, duration and start are
/// those of the fit; paralysis, loads and everything else are its own. `settings` are put over it as over the
/// scenario of the fit. Throws InputError.
OtherScenario other_scenario(const SubjectFit& fit, const std::filesystem::path& path,
                             const std::vector<std::string>& settings);

/// Returns whether the other trunk has the shape of the subject's at rest, to a micrometre.
bool same_geometry(const SubjectFit& fit, const OtherScenario& other);

}  // namespace trunk
