#include "registration/similarity.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

Eigen::Matrix3Xd columns_of(std::span<const Vec3d> points) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) << points[i].x(), points[i].y(), points[i].z();
  return columns;
}

}  // namespace

double Similarity::angle() const noexcept {
  return 2.0 * std::atan2(norm(rotation.v), std::abs(rotation.w));
}

Similarity fitted_similarity(std::span<const Vec3d> from, std::span<const Vec3d> to) {
  const Eigen::Matrix4d found = similarity_between(columns_of(from), columns_of(to), true);
  const Eigen::Matrix3d scaled = found.topLeftCorner<3, 3>();
  const double scale = std::cbrt(scaled.determinant());
  const Eigen::Quaterniond q(Eigen::Matrix3d(scaled / scale));
  return {scale, {q.w(), {q.x(), q.y(), q.z()}}, {found(0, 3), found(1, 3), found(2, 3)}};
}

}  // namespace trunk
