#include "registration/attractor.hpp"

#include "surface/distances.hpp"

namespace trunk {
namespace {

double counted(double distance, double reach) {
  const double scaled = distance / reach;
  return 1.0 / ((1.0 + scaled * scaled) * (1.0 + scaled * scaled));
}

void add(const LinearActuator& actuator, double sticking, std::vector<LinearActuator>& actuators) {
  actuators.push_back(actuator);
  actuators.push_back({actuator.particle, actuator.weight, actuator.target, sticking * actuator.stiffness});
}

}  // namespace

bool Attraction::faces(const Vec3d& of_part, const Vec3d& of_target) const {
  constexpr double alike = 0.5;  // cosine
  if (facing == Facing::any) return true;
  const double cosine = dot(of_part, of_target);
  return facing == Facing::alike ? cosine > alike : cosine < -alike;
}

Attractor::Attractor(const Attraction& attraction, std::span<const Vec3d> rest)
    : attraction_(attraction), target_(*attraction.target), area_(surface_area(rest, attraction.part)) {
  constexpr double spacing = 0.012;
  constexpr std::size_t target_points = 2500;
  if (attraction.direction != Attraction::Direction::target_to_part)
    samples_ = surface_samples(rest, attraction.part, spacing);
  if (attraction.direction != Attraction::Direction::part_to_target) {
    points_ = spread_over(attraction.target->points, attraction.target->triangles, target_points);
    for (const auto& hit : target_.closest(points_)) normals_.push_back(target_.normal(hit));
  }
}

void Attractor::add_to(std::vector<LinearActuator>& actuators, std::span<const Vec3d> position,
                       double stiffness, double reach) const {
  // A surface with one direction only, such as the skin, would not hold a trunk that slides along it.
  const double sticking = attraction_.direction == Attraction::Direction::both ? 0.01 : 1.0;
  const auto& part = attraction_.part;
  std::vector<Vec3d> of_part;
  for (const SurfaceSample& sample : samples_) of_part.push_back(sample.in(position, part));
  const auto on_target = target_.closest(of_part);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Triangle& triangle = part[static_cast<std::size_t>(samples_[i].triangle)];
    const Vec3d normal = unit_normal(position, triangle);
    const auto& hit = on_target[i];
    if (!target_.ends_before(of_part[i], normal, hit) && attraction_.faces(normal, target_.normal(hit)))
      add({triangle, samples_[i].weight, hit.point,
           stiffness * samples_[i].area / area_ * counted(hit.distance, reach), normal},
          sticking, actuators);
  }
  if (points_.empty()) return;
  const double share = stiffness / static_cast<double>(points_.size());
  const auto on_part = ClosestPoints(position, part)(points_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto& hit = on_part[i];
    const Triangle& triangle = part[static_cast<std::size_t>(hit.triangle)];
    const Vec3d normal = unit_normal(position, triangle);
    if (attraction_.faces(normal, normals_[i]))
      add({triangle, hit.weight, points_[i], share * counted(hit.distance, reach), normal}, sticking,
          actuators);
  }
}

}  // namespace trunk
