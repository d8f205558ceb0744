#include "surface/signed_distance.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

Vec3d unit_or_zero(const Vec3d& a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vec3d();
}

std::pair<int, int> sorted_pair(int a, int b) {
  return std::minmax(a, b);
}

}  // namespace

SignedDistance::SignedDistance(std::span<const Vec3d> points, std::span<const Triangle> triangles)
    : closest_(points, triangles), triangles_(triangles.begin(), triangles.end()), corners_(points.size()) {
  const auto at = [&](int i) -> const Vec3d& { return points[static_cast<std::size_t>(i)]; };
  for (const Triangle& t : triangles_) {
    const Vec3d face = unit_or_zero(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
    faces_.push_back({face, false});
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      const auto [edge, first] = edges_.try_emplace(sorted_pair(a, b));
      edge->second.normal += face;
      edge->second.border = first;  // until a second triangle comes
      const double cosine = dot(unit_or_zero(at(b) - at(a)), unit_or_zero(at(c) - at(a)));
      corners_[static_cast<std::size_t>(a)].normal += std::acos(std::clamp(cosine, -1.0, 1.0)) * face;
    }
  }
  for (const auto& [edge, feature] : edges_)
    if (feature.border)
      for (const int corner : {edge.first, edge.second})
        corners_[static_cast<std::size_t>(corner)].border = true;
}

const SignedDistance::Feature& SignedDistance::feature_at(const ClosestPoints::Hit& hit) const {
  const Triangle& t = triangles_[static_cast<std::size_t>(hit.triangle)];
  std::array<int, 3> on{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (hit.weight[i] != 0.0) on[count++] = t[i];
  if (count == 1) return corners_[static_cast<std::size_t>(on[0])];
  if (count == 2) return edges_.at(sorted_pair(on[0], on[1]));
  return faces_[static_cast<std::size_t>(hit.triangle)];
}

SignedDistance::Hit SignedDistance::operator()(const Vec3d& p) const {
  const ClosestPoints::Hit hit = closest_(p);
  const Feature& feature = feature_at(hit);
  const bool behind = dot(p - hit.point, feature.normal) < 0.0;
  return {hit, behind ? -hit.distance : hit.distance, feature.border};
}

}  // namespace trunk
