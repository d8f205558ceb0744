#pragma once

#include <string>

#include "anatomy/trunk.hpp"
#include "errors/input_error.hpp"
#include "math/piecewise_linear.hpp"

namespace trunk {

/// A load on every particle of a region, direction * magnitude(t). It is one of
///  - force: N on each particle,
///  - displacement: m from rest, imposed along `axes`,
///  - acceleration: m/s2, as a force on each particle's mass,
///  - pressure: Pa against the outer side of the triangles within the region. It follows the triangles; with
///    a direction, it acts along that direction on their area at rest.
struct RegionLoad {
  enum class Kind { force, displacement, acceleration, pressure };
  Kind kind = Kind::force;
  std::string region;  // as in selected_particles
  Vec3d direction;
  Vec3d axes;  // for a displacement: 1: imposed, 0: free
  PiecewiseLinear magnitude;
  Place at;  // in the user's file, for messages
};

/// Adds a load to the trunk's model. Throws InputError at the load's place if the region is not there, if no
/// triangle lies within it (pressure) or if a moving rigid part carries its particles (displacement).
void apply(const RegionLoad& load, Trunk& trunk);

}  // namespace trunk
