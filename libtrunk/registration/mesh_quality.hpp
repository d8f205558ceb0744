#pragma once

#include <set>
#include <span>

#include "anatomy/trunk_mesh.hpp"

namespace trunk {

/// How well formed the triangles of a trunk's two closed surfaces are.
struct MeshQuality {
  double smallest_angle = 0.0;  // rad, of any triangle
  int folded = 0;               // triangles turned by 90 degrees and more from where they faced

  /// None folded, none so thin that its plane is round-off or its time step tiny: 0.5 degrees (our choice).
  bool sound() const noexcept;
};

/// At `position`, [particles], against the mesh's own, which has to stand in the same directions.
MeshQuality mesh_quality(const TrunkMesh& before, std::span<const Vec3d> position);

/// Corners of triangles that are folded, or have become thinner from one position to the next and now have an
/// angle smaller than `thin`, rad.
std::set<int> particles_of_thinned_triangles(const TrunkMesh& before, std::span<const Vec3d> from,
                                             std::span<const Vec3d> to, double thin);

}  // namespace trunk
