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

/// One breath to simulate: everything that a scenario file says, in SI units.
struct Scenario {
  std::string title = "trunk";
  TrunkGeometry geometry;
  std::shared_ptr<const TrunkMesh> mesh;  // a trunk from a file; empty: the template of `geometry`
  std::string mesh_file;                  // the file of `mesh`
  Tissue tissue;
  Reaction reaction = Reaction::variational;
  Parameters<double> parameters{4000.0, 30.0, 20.0, 1.0};
  BreathActivation<double> activation;
  TimeGrid time;
  bool start_given = false;                   // the scenario says how it starts, so that its text says it too
  bool automatic_step = false;                // time.dt_s is still to be chosen
  std::optional<TimeStepChoice> step_choice;  // how `time` was chosen, if the program chose it
  double frame_every_s = 0.01;                // between stored trajectory frames; 0: none are stored
  Vec3d gravity;                              // m/s2; 0: gravity is in the rest shape, as it was imaged
  std::vector<RegionLoad> loads;
  std::vector<RigidPart> rigid;
  bool lung_acts = false;  // there is a [lung] or an [airway]: the model gets a pleura
  Pleura pleura;
  PiecewiseLinear abdominal_volume;  // fraction of rest; empty: constant
};

/// Returns the number of steps between stored frames; 0 if none are stored.
int frame_stride(const Scenario& scenario);

/// Returns the mesh of a scenario: that of its file or the template. Throws InputError if the sizes of the
/// template leave no room for the lung.
TrunkMesh mesh_of(const Scenario& scenario);

/// Returns the trunk with the scenario's rigid parts and loads, and with its recoil if breathing repeats.
/// Throws InputErrors with all loads that are impossible or cannot repeat, and InputError if the mesh, the
/// tissue or a rigid part is.
Trunk make_trunk(const Scenario& scenario);

/// Returns the time in which the relaxed trunk, with its lung and airway, loses 63 % of its volume, s;
/// nothing if it does not come to rest, or swings. All fibres hold the volume before, those of a paralysed
/// side too: held by one side, the domes would sway for longer than the volume lasts.
std::optional<double> recoil_time_s(const Trunk& trunk, const Scenario& scenario);

/// Throws InputErrors with all courses that cannot repeat, if breathing should.
void require_repeating(const Scenario& scenario);

/// Throws InputError, which names the bound, unless the time step is below the stability bound at full
/// activation and the duration is 1 to 1e7 steps; and as require_memory does.
void require_stable(const Scenario& scenario, const Trunk& trunk);

/// Throws InputError if breathing should repeat, but the trunk does not forget its start in time (see
/// lead_s).
void require_memory(const Scenario& scenario, const Trunk& trunk);

}  // namespace trunk
