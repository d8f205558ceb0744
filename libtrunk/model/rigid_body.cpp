#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "errors/input_error.hpp"
#include "model/model.hpp"

namespace trunk {
namespace {

Eigen::Vector3d column(const Vec3d& a) {
  return {a.x(), a.y(), a.z()};
}

void require_carriable(const RigidBody& body, const Model& model) {
  if (body.particles.empty() && body.motion != RigidBody::Motion::fixed)
    throw InputError({}, fmt::format("rigid body '{}' carries no particle", body.name));
  for (int i : body.particles) {
    if (i < 0 || static_cast<std::size_t>(i) >= model.particles())
      throw InputError(
          {}, fmt::format("rigid body '{}' carries particle {}, which does not exist", body.name, i));
    for (const RigidBody& other : model.bodies)
      if (std::find(other.particles.begin(), other.particles.end(), i) != other.particles.end())
        throw InputError({},
                         fmt::format("particle {} is carried by two rigid bodies, '{}' and '{}'", i,
                                     other.name, body.name),
                         "one");
  }
}

/// Sets the body's mass, centre and inertia to those of its particles.
void derive_inertia(const Model& model, RigidBody& body) {
  const auto at = [&](int i) { return static_cast<std::size_t>(i); };
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (int i : body.particles) {
    body.mass += model.mass[at(i)];
    body.damping_weight += model.damping_weight[at(i)];
    moment += model.mass[at(i)] * column(model.rest[at(i)]);
  }
  const Eigen::Vector3d centre = moment / body.mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (int i : body.particles) {
    const Eigen::Vector3d r = column(model.rest[at(i)]) - centre;
    inertia += model.mass[at(i)] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  const Eigen::Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  if (!(principal(0) > 1e-9 * principal(2)))
    throw InputError({}, fmt::format("the particles of the free rigid body '{}' lie on a line", body.name),
                     "three or more that do not");
  const Eigen::Matrix3d inverse = inertia.inverse();
  body.centre = {centre(0), centre(1), centre(2)};
  for (int row = 0; row < 3; ++row)
    body.inverse_inertia[row] = {inverse(row, 0), inverse(row, 1), inverse(row, 2)};
}

}  // namespace

void carry(RigidBody body, Model& model) {
  require_carriable(body, model);
  if (body.motion == RigidBody::Motion::driven) body.centre = body.imposed.point;
  if (body.motion == RigidBody::Motion::free) {
    derive_inertia(model, body);
    for (std::size_t row = 0; row < model.abdomen.rings.size(); ++row)
      if (std::find(body.particles.begin(), body.particles.end(), model.abdomen.rings.vertex[row]) !=
          body.particles.end())
        body.held_rows.push_back(static_cast<int>(row));
  }
  for (int i : body.particles) model.mobility[static_cast<std::size_t>(i)] = {0.0, 0.0, 0.0};
  model.bodies.push_back(std::move(body));
}

}  // namespace trunk
