#include "registration/measured_target.hpp"

#include <algorithm>
#include <map>

namespace trunk {

MeasuredTarget::MeasuredTarget(const MeasuredSurface& surface)
    : surface_(&surface), closest_(surface.points, surface.triangles) {
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  for (const auto& [edge, count] : uses)
    if (count == 1) {
      edges_.insert(edge);
      points_.insert({edge.first, edge.second});
    }
}

bool MeasuredTarget::on_border(const ClosestPoints::Hit& hit) const {
  const Triangle& t = surface_->triangles[static_cast<std::size_t>(hit.triangle)];
  std::array<int, 3> on{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (hit.weight[k] != 0.0) on[count++] = t[k];
  if (count == 1) return points_.contains(on[0]);
  return count == 2 && edges_.contains(std::minmax(on[0], on[1]));
}

}  // namespace trunk
