#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "registration/insertion_line.hpp"
#include "registration/linear_actuators.hpp"

namespace trunk {

/// Raises or lowers the costal insertion to the smooth curve of a measured one. What lies above follows in
/// proportion up to the border of the central tendon and along the lung's wall to its top, what lies below
/// down to the pelvis. z is up.
void fit_insertion(const InsertionLine& line, TrunkMesh& mesh);

/// The costal insertion is drawn to its line, and slides along it. mesh: at rest; position: [particles] m;
/// `per_length`: N/m2. => actuators
void add_insertion(const TrunkMesh& mesh, const InsertionLine& insertion, std::span<const Vec3d> position,
                   double per_length, std::vector<LinearActuator>& actuators);

/// The rows of the zone of apposition slide along the muscle lines until these have the length wanted, m, in
/// the mean. => actuators
void add_apposition_length(const TrunkMesh& mesh, double wanted, std::span<const Vec3d> position,
                           double per_length, std::vector<LinearActuator>& actuators);

}  // namespace trunk
