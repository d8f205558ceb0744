#pragma once

#include "anatomy/breath_run.hpp"
#include "results/records.hpp"

namespace trunk {

/// Returns the frames of a run, and the triangles, fibres and regions of its particles.
Trajectory trajectory_of(const Trunk& trunk, const BreathRun& run, double dt_s);

}  // namespace trunk
