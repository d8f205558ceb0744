#include "report/motion.hpp"

#include <algorithm>

#include "anatomy/measures.hpp"
#include "constraints/rigid_bodies.hpp"

namespace trunk {
namespace {

constexpr double mm = 1e-3, contact_gap_m = 1e-6;

/// How far a particle is inside the surface of its support, m, to second order; negative: outside.
double gap(const Support& support, const RigidBody& body, double time_s, const Vec3d& position) {
  const Pose<double> pose = imposed_pose(body, time_s);
  const Vec3d y = turn_back(pose.rotation, position - placed(body, pose, support.point));
  const auto row = [&](int k) { return dot(support.curvature[k], y); };
  return -dot(support.normal, y) - 0.5 * dot(Vec3d{row(0), row(1), row(2)}, y);
}

}  // namespace

Motion motion_of(const Trunk& trunk, std::span<const double> time_s,
                 std::span<const std::vector<Vec3d>> frames) {
  const Model& model = trunk.model;
  Motion motion;
  for (const Support& s : model.supports) motion.support_particle.push_back(s.particle);
  double strongest = 0.0;
  for (const Fibre& f : model.fibres) strongest = std::max(strongest, f.activity);
  for (const Fibre& f : model.fibres)
    motion.fibre_activity.push_back(strongest > 0.0 ? f.activity / strongest : 0.0);
  const Shape rest = shape_of(trunk, model.rest);
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    const Measures m = measures_between(rest, shape_of(trunk, frames[frame]));
    motion.delta_l_mm.push_back(m.delta_l / mm);
    motion.delta_h_mm.push_back(m.delta_h / mm);
    motion.delta_r_mm.push_back(m.delta_r / mm);
    motion.excursion_right_mm.push_back(m.excursion_right / mm);
    motion.excursion_left_mm.push_back(m.excursion_left / mm);
    for (const Support& s : model.supports) {
      const RigidBody& body = model.bodies[static_cast<std::size_t>(s.body)];
      const Vec3d& position = frames[frame][static_cast<std::size_t>(s.particle)];
      motion.touching.push_back(gap(s, body, time_s[frame], position) < contact_gap_m ? 1 : 0);
    }
  }
  return motion;
}

}  // namespace trunk
