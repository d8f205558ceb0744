#include "surface/align.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "linear_algebra/decompositions.hpp"
#include "surface/distances.hpp"

namespace trunk {
namespace {

constexpr std::size_t align_samples = 2000;

RigidMove move_of(const Eigen::Matrix4d& m) {
  RigidMove move;
  for (int i = 0; i < 3; ++i) move.rows[static_cast<std::size_t>(i)] = {m(i, 0), m(i, 1), m(i, 2)};
  move.shift = {m(0, 3), m(1, 3), m(2, 3)};
  move.angle = Eigen::AngleAxisd(Eigen::Matrix3d(m.topLeftCorner<3, 3>())).angle();
  return move;
}

}  // namespace

Vec3d middle_of_area(std::span<const Vec3d> points, std::span<const Triangle> triangles) {
  Vec3d sum;
  const std::vector<Vec3d> spread = spread_over(points, triangles, align_samples);
  for (const Vec3d& p : spread) sum += p;
  return (1.0 / static_cast<double>(std::max<std::size_t>(spread.size(), 1))) * sum;
}

RigidMove aligned(std::span<const Vec3d> points, std::span<const Triangle> triangles, const ClosestPoints& to,
                  const Vec3d& middle) {
  const std::vector<Vec3d> samples = spread_over(points, triangles, align_samples);
  RigidMove move;
  move.shift = middle - middle_of_area(points, triangles);
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(samples.size())), target = from;
  for (int round = 0; round < 100; ++round) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vec3d &p = samples[i], q = to(move(p)).point;
      from.col(static_cast<Eigen::Index>(i)) << p.x(), p.y(), p.z();
      target.col(static_cast<Eigen::Index>(i)) << q.x(), q.y(), q.z();
    }
    const RigidMove next = move_of(similarity_between(from, target, false));
    double farthest = 0.0;
    for (const Vec3d& p : samples) farthest = std::max(farthest, norm(next(p) - move(p)));
    move = next;
    if (farthest < 1e-6) break;
  }
  return move;
}

}  // namespace trunk
