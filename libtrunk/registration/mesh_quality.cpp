#include "registration/mesh_quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trunk {
namespace {

const Vec3d& at(std::span<const Vec3d> position, int particle) {
  return position[static_cast<std::size_t>(particle)];
}

Vec3d area_of(std::span<const Vec3d> position, const Triangle& t) {
  return cross(at(position, t[1]) - at(position, t[0]), at(position, t[2]) - at(position, t[0]));
}

double smallest_angle_of(std::span<const Vec3d> position, const Triangle& t) {
  const double area = norm(area_of(position, t));
  double smallest = std::numbers::pi;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d& corner = at(position, t[k]);
    const double along = dot(at(position, t[(k + 1) % 3]) - corner, at(position, t[(k + 2) % 3]) - corner);
    smallest = std::min(smallest, std::atan2(area, along));
  }
  return smallest;
}

void add(std::span<const Triangle> triangles, std::span<const Vec3d> before, std::span<const Vec3d> position,
         MeshQuality& quality) {
  for (const Triangle& t : triangles) {
    if (!(dot(area_of(before, t), area_of(position, t)) > 0.0)) ++quality.folded;
    quality.smallest_angle = std::min(quality.smallest_angle, smallest_angle_of(position, t));
  }
}

}  // namespace

bool MeshQuality::sound() const noexcept {
  return folded == 0 && smallest_angle > 0.5 * std::numbers::pi / 180.0;
}

MeshQuality mesh_quality(const TrunkMesh& before, std::span<const Vec3d> position) {
  MeshQuality quality{std::numbers::pi, 0};
  add(before.abdomen, before.rest, position, quality);
  add(before.lung, before.rest, position, quality);
  return quality;
}

}  // namespace trunk
