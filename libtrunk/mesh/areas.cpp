#include "mesh/areas.hpp"

namespace trunk {

double area_of(const Triangle& triangle, std::span<const Vec3d> position) {
  const auto at = [&](std::size_t corner) { return position[static_cast<std::size_t>(triangle[corner])]; };
  return 0.5 * norm(cross(at(1) - at(0), at(2) - at(0)));
}

std::vector<double> particle_areas(std::span<const Triangle> triangles, std::span<const Vec3d> position) {
  std::vector<double> area(position.size(), 0.0);
  for (const Triangle& t : triangles)
    for (const int corner : t) area[static_cast<std::size_t>(corner)] += area_of(t, position) / 3.0;
  return area;
}

}  // namespace trunk
