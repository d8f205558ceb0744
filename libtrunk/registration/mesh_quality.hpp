#pragma once

#include <span>

#include "anatomy/trunk_mesh.hpp"

namespace trunk {

/// How well formed the triangles of a trunk's two closed surfaces are.
struct MeshQuality {
  double smallest_angle = 0.0;  // rad, of any triangle
  int folded = 0;               // triangles that face against those around them

  /// None folded, none so thin that its plane is round-off or its time step tiny: 0.5 degrees (our choice).
  bool sound() const noexcept;
};

MeshQuality mesh_quality(const TrunkMesh& mesh, std::span<const Vec3d> position);

}  // namespace trunk
