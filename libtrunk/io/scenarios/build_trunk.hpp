#pragma once

#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Builds the trunk of a scenario and checks that its time step is stable, unless the step is still "auto".
/// Throws InputError with the file and the line to change.
Trunk build_trunk(const ScenarioFile& file);

/// Builds the trunk like build_trunk. If the time step is "auto", it also chooses the step with some
/// simulations. The step suits a model that is `stiffer` times as stiff.
Trunk build_timed_trunk(ScenarioFile& file, double stiffer = 1.0);

/// Chooses the time step with some simulations if it is "auto". The step suits a model that is `stiffer`
/// times as stiff.
void choose_time_step(ScenarioFile& file, const Trunk& trunk, double stiffer = 1.0);

/// The parts of build_trunk. require_stable does what require_memory does as well.
Trunk assemble_trunk(const ScenarioFile& file);
void require_stable(const ScenarioFile& file, const Trunk& trunk);
void require_memory(const ScenarioFile& file, const Trunk& trunk);

}  // namespace trunk
