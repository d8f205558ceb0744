#include "registration/target_surface.hpp"

#include <algorithm>

#include "registration/surface_samples.hpp"

namespace trunk {
namespace {

/// Returns the edges of one triangle only, sorted.
std::set<std::pair<int, int>> border_edges(std::span<const Triangle> triangles) {
  std::vector<std::pair<int, int>> all;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) all.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(all.begin(), all.end());
  std::set<std::pair<int, int>> border;
  for (auto edge = all.begin(); edge != all.end();) {
    const auto next = std::upper_bound(edge, all.end(), *edge);
    if (next - edge == 1) border.insert(border.end(), *edge);
    edge = next;
  }
  return border;
}

}  // namespace

TargetSurface::TargetSurface(const MeasuredSurface& surface)
    : surface_(&surface),
      closest_(surface.points, surface.triangles),
      edges_(border_edges(surface.triangles)),
      at_border_(surface.points.size()) {
  for (const auto& [a, b] : edges_)
    at_border_[static_cast<std::size_t>(a)] = at_border_[static_cast<std::size_t>(b)] = true;
}

const Triangle& TargetSurface::triangle(const ClosestPoints::Hit& hit) const {
  return surface_->triangles[static_cast<std::size_t>(hit.triangle)];
}

Vec3d TargetSurface::normal(const ClosestPoints::Hit& hit) const {
  return unit_normal(surface_->points, triangle(hit));
}

bool TargetSurface::on_border(const ClosestPoints::Hit& hit) const {
  const Triangle& t = triangle(hit);
  std::array<int, 3> on{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (hit.weight[k] != 0.0) on[count++] = t[k];
  if (count == 1) return at_border_[static_cast<std::size_t>(on[0])];
  return count == 2 && edges_.contains(std::minmax(on[0], on[1]));
}

bool TargetSurface::ends_before(const Vec3d& from, const Vec3d& normal, const ClosestPoints::Hit& hit) const {
  constexpr double oblique = 0.7;  // cosine
  if (on_border(hit)) return true;
  const Triangle& t = triangle(hit);
  const auto point = [&](std::size_t k) { return surface_->points[static_cast<std::size_t>(t[k])]; };
  const bool jagged =
      std::any_of(t.begin(), t.end(), [&](int i) { return at_border_[static_cast<std::size_t>(i)]; });
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, norm(point((k + 1) % 3) - point(k)));
  return jagged && hit.distance > longest && std::abs(dot(from - hit.point, normal)) < oblique * hit.distance;
}

}  // namespace trunk
