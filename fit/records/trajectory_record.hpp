#pragma once

#include "anatomy/breath_run.hpp"
#include "results/records.hpp"

namespace trunk {

/// The frames of a run, and what connects the particles.
Trajectory trajectory_of(const Trunk& trunk, const BreathRun& run, double dt_s);

}  // namespace trunk
