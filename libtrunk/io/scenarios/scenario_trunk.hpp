#pragma once

#include "scenarios/read_scenario.hpp"
#include "trunks/read_trunk_pml.hpp"

/// Private to the scenarios layer: the trunk that a scenario takes from a file.
namespace trunk {

/// Adopts a trunk, except for rigid parts that the scenario describes itself.
void adopt_trunk(TrunkFile trunk, ScenarioFile& file);

/// Reads the trunk that the scenario names, unless it is read already; throws InputError.
void read_named_trunk(ScenarioFile& file);

/// Throws InputError if the file of the trunk overrides a setting, which would otherwise be ignored silently.
void require_effect(const Setting& setting, const Scenario& scenario);

}  // namespace trunk
