#pragma once

#include "anatomy/trunk_mesh.hpp"

namespace trunk {

// The parts of a trunk's surfaces that measured surfaces show.

/// Returns the diaphragm, from the costal insertion up.
std::vector<Triangle> diaphragm_of(const TrunkMesh& mesh);
/// Returns the abdominal wall, without the pelvic floor.
std::vector<Triangle> abdominal_wall_of(const TrunkMesh& mesh);
/// Returns the zone of apposition and the lung's wall, which lie on the ribs.
std::vector<Triangle> rib_side_of(const TrunkMesh& mesh);
/// Returns everything that the skin covers: abdominal wall and ribs.
std::vector<Triangle> outside_of(const TrunkMesh& mesh);

}  // namespace trunk
