#pragma once

#include <set>
#include <span>

#include "anatomy/trunk_mesh.hpp"

namespace trunk {

/// The quality of the triangles of a trunk's two closed surfaces.
struct MeshQuality {
  double smallest_angle = 0.0;  // rad, of any triangle
  int folded = 0;               // triangles that turned by 90 degrees or more

  /// Returns true if no triangle is folded and all angles are above 0.5 degrees (our choice). In thinner
  /// triangles the plane is round-off, and the time step is tiny.
  bool sound() const noexcept;
};

/// Returns the quality at `position`: [particles] m. `before` is the mesh in the same directions.
MeshQuality mesh_quality(const TrunkMesh& before, std::span<const Vec3d> position);

/// Returns the corners of triangles that are folded, and of those that became thinner from one position to
/// the next and now have an angle below `thin`, rad.
std::set<int> particles_of_thinned_triangles(const TrunkMesh& before, std::span<const Vec3d> from,
                                             std::span<const Vec3d> to, double thin);

}  // namespace trunk
