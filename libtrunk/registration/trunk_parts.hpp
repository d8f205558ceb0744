#pragma once

#include "anatomy/trunk_mesh.hpp"

namespace trunk {

/// Parts of a trunk's surfaces that measured ones show.
std::vector<Triangle> diaphragm_of(const TrunkMesh& mesh);       // from the costal insertion up
std::vector<Triangle> abdominal_wall_of(const TrunkMesh& mesh);  // without the pelvic floor
std::vector<Triangle> rib_side_of(const TrunkMesh& mesh);        // zone of apposition and lung wall
std::vector<Triangle> outside_of(const TrunkMesh& mesh);         // all that skin covers: wall, ribs

}  // namespace trunk
