#pragma once

#include <string>
#include <vector>

#include "activation/breath_activation.hpp"
#include "anatomy/trunk.hpp"
#include "dynamics/simulate.hpp"
#include "model/parameters.hpp"

namespace trunk {

/// A force or an imposed displacement on every particle of a region, direction * magnitude(t).
struct RegionLoad {
  enum class Kind { force, displacement };
  Kind kind = Kind::force;
  std::string region;
  Vec3d direction;            // as given; a displacement is imposed on the axes where it is not 0
  PiecewiseLinear magnitude;  // N a particle, or m
  std::string origin;         // file:line, for messages
};

/// One breath to simulate: everything a scenario file says, in SI units.
struct Scenario {
  std::string title = "trunk";
  TrunkGeometry geometry;
  Tissue tissue;
  Reaction reaction = Reaction::variational;
  Parameters<double> parameters{4000.0, 30.0, 20.0, 1.0};
  BreathActivation<double> activation;
  TimeGrid time;
  double frame_every_s = 0.01;  // between stored trajectory frames
  Vec3d gravity;                // m/s2; 0: the rest shape was imaged under gravity, which is thus in it
  std::vector<RegionLoad> loads;
  PiecewiseLinear abdominal_volume;  // fraction of rest; empty: constant
};

/// Builds the trunk with the scenario's loads. Throws InputError.
Trunk make_trunk(const Scenario& scenario);

/// Throws InputError unless the time step is below the stability bound at full activation and the duration is
/// a sensible number of steps. The text names the bound.
void require_stable(const Scenario& scenario, const Trunk& trunk);

}  // namespace trunk
