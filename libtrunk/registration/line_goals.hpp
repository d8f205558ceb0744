#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "registration/insertion_line.hpp"
#include "registration/linear_actuators.hpp"

namespace trunk {

/// Raises or lowers the costal insertion to the smooth curve of a measured one. Particles above follow in
/// proportion, up to the border of the central tendon and along the lung's wall to its top. Particles below
/// follow down to the pelvis. z is up. => mesh.rest
void fit_insertion(const InsertionLine& line, TrunkMesh& mesh);

/// Adds actuators that pull the costal insertion to its line, along which it slides. mesh: at rest; position:
/// [particles] m; per_length: N/m2. => actuators
void add_insertion(const TrunkMesh& mesh, const InsertionLine& insertion, std::span<const Vec3d> position,
                   double per_length, std::vector<LinearActuator>& actuators);

/// Adds actuators that slide the rows of the zone of apposition along the muscle lines until their mean
/// length is `wanted`, m. => actuators
void add_apposition_length(const TrunkMesh& mesh, double wanted, std::span<const Vec3d> position,
                           double per_length, std::vector<LinearActuator>& actuators);

}  // namespace trunk
