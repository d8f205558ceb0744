#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

// The parts of a trunk's surfaces that measured surfaces show.

/// Returns the diaphragm, from the costal insertion up.
std::vector<Triangle> diaphragm_of(const TrunkMesh& mesh);
/// Returns the abdominal wall, without the pelvic floor.
std::vector<Triangle> abdominal_wall_of(const TrunkMesh& mesh);
/// Returns the zone of apposition and the lung's wall, which lie on the ribs.
std::vector<Triangle> rib_side_of(const TrunkMesh& mesh);
/// Returns the triangles on one side of the middle of their surface: at greater x if `sign` is positive, at
/// smaller x if it is negative.
std::vector<Triangle> side_of(const TrunkMesh& mesh, const std::vector<Triangle>& surface, double sign);
/// Returns a surface together with its mirror image at the plane of this x.
MeasuredSurface with_mirror_image(const MeasuredSurface& half, double x);
/// Returns everything that the skin covers: abdominal wall and ribs.
std::vector<Triangle> outside_of(const TrunkMesh& mesh);

}  // namespace trunk
