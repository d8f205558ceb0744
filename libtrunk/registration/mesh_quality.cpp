#include "registration/mesh_quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/units.hpp"

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

bool folded(std::span<const Vec3d> before, std::span<const Vec3d> position, const Triangle& t) {
  return !(dot(area_of(before, t), area_of(position, t)) > 0.0);
}

}  // namespace

bool MeshQuality::sound() const noexcept {
  return folded == 0 && smallest_angle > 0.5 * rad_per_degree;
}

MeshQuality mesh_quality(const TrunkMesh& before, std::span<const Vec3d> position) {
  MeshQuality quality{std::numbers::pi, 0};
  for (const auto* triangles : {&before.abdomen, &before.lung})
    for (const Triangle& t : *triangles) {
      quality.folded += folded(before.rest, position, t);
      quality.smallest_angle = std::min(quality.smallest_angle, smallest_angle_of(position, t));
    }
  return quality;
}

std::set<int> particles_of_thinned_triangles(const TrunkMesh& before, std::span<const Vec3d> from,
                                             std::span<const Vec3d> to, double thin) {
  std::set<int> particles;
  for (const auto* triangles : {&before.abdomen, &before.lung})
    for (const Triangle& t : *triangles) {
      const double angle = smallest_angle_of(to, t);
      if (folded(before.rest, to, t) || (angle < thin && angle < smallest_angle_of(from, t)))
        particles.insert(t.begin(), t.end());
    }
  return particles;
}

}  // namespace trunk
