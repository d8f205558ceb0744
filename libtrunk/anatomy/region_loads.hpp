#pragma once

#include <string>

#include "anatomy/trunk.hpp"
#include "errors/input_error.hpp"
#include "math/piecewise_linear.hpp"

namespace trunk {

/// A load on every particle of a region, over time: direction * magnitude(t) as
///  - force: N on each particle,
///  - displacement: m from rest, imposed along `axes`,
///  - acceleration: m/s2, as a force on each particle's mass,
///  - pressure: Pa against the outer side of the triangles within the region, following them; with a
///  direction, along
///    that on their area at rest.
struct RegionLoad {
  enum class Kind { force, displacement, acceleration, pressure };
  Kind kind = Kind::force;
  std::string region;  // as selected_particles takes it
  Vec3d direction;
  Vec3d axes;  // of a displacement: 1 imposed, 0 free
  PiecewiseLinear magnitude;
  Place at;  // in the user's file, for messages
};

/// Adds a load to the trunk's model. Throws InputError at the load's place if the region is not there, if no
/// triangle lies within it (pressure) or if a moving rigid part carries its particles (displacement).
void apply(const RegionLoad& load, Trunk& trunk);

}  // namespace trunk
