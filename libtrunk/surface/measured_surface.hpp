#pragma once

#include <string>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// A surface that somebody segmented or reconstructed: triangles in the trunk's axes. It may be open, consist
/// of several pieces and have holes. A closed one faces outward, an open one upward or away from its middle.
struct MeasuredSurface {
  std::string name;                 // for messages and tables
  std::vector<Vec3d> points;        // [points] m; x right, y forward, z up (RAS), any origin
  std::vector<Triangle> triangles;  // indices of points, counter-clockwise seen from the side it faces
};

}  // namespace trunk
