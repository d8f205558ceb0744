#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "activation/breath_activation.hpp"
#include "anatomy/region_loads.hpp"
#include "anatomy/trunk.hpp"
#include "dynamics/auto_time_step.hpp"
#include "dynamics/simulate.hpp"
#include "model/parameters.hpp"

namespace trunk {

/// One breath to simulate: everything a scenario file says, in SI units.
struct Scenario {
  std::string title = "trunk";
  TrunkGeometry geometry;
  std::shared_ptr<const TrunkMesh> mesh;  // a trunk that was read; empty: the template of `geometry`
  std::string mesh_file;                  // where it was read from
  Tissue tissue;
  Reaction reaction = Reaction::variational;
  Parameters<double> parameters{4000.0, 30.0, 20.0, 1.0};
  BreathActivation<double> activation;
  TimeGrid time;
  bool automatic_step = false;                // time.dt_s is still to be chosen
  std::optional<TimeStepChoice> step_choice;  // how `time` was chosen, where it was
  double frame_every_s = 0.01;                // between stored trajectory frames; 0: none are stored
  Vec3d gravity;  // m/s2; 0: the rest shape was imaged under gravity, which is thus in it
  std::vector<RegionLoad> loads;
  std::vector<RigidPart> rigid;
  PiecewiseLinear abdominal_volume;  // fraction of rest; empty: constant
};

/// Steps between stored frames; 0: none are stored.
int frame_stride(const Scenario& scenario);

/// The trunk's particles before anything is done to them. Throws InputError.
TrunkMesh mesh_of(const Scenario& scenario);

/// Builds the trunk with the scenario's loads. Throws InputError.
Trunk make_trunk(const Scenario& scenario);

/// Throws InputError unless the time step is below the stability bound at full activation and the duration is
/// a sensible number of steps. The text names the bound.
void require_stable(const Scenario& scenario, const Trunk& trunk);

}  // namespace trunk
