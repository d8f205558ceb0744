#pragma once

#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Builds the trunk and requires a stable time step, unless that is still to be chosen. InputErrors name the
/// file and line to change.
Trunk build_trunk(const ScenarioFile& file);

/// The same, and chooses the time step where the scenario says "auto", which takes some simulations; one that
/// serves a model `stiffer` times as stiff.
Trunk build_timed_trunk(ScenarioFile& file, double stiffer = 1.0);

/// The two by themselves.
Trunk assemble_trunk(const ScenarioFile& file);
void require_stable(const ScenarioFile& file, const Trunk& trunk);

}  // namespace trunk
