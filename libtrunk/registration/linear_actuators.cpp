#include "registration/linear_actuators.hpp"

#include <Eigen/SparseCholesky>
#include <map>

#include "errors/input_error.hpp"
#include "forces/shape_memory.hpp"

namespace trunk {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Corners = std::array<int, 3>;
using CornerStiffness = Eigen::Matrix<double, 9, 9>;  // x, y, z of each corner

/// Returns the summed stiffness of all actuators on the same particles.
std::map<Corners, CornerStiffness> stiffness_by_corners(std::span<const LinearActuator> actuators) {
  std::map<Corners, CornerStiffness> sums;
  for (const LinearActuator& a : actuators) {
    CornerStiffness& sum = sums.try_emplace(a.particle, CornerStiffness::Zero()).first->second;
    const bool slides = dot(a.along, a.along) > 0.0;
    const Eigen::Vector3d weight(a.weight[0], a.weight[1], a.weight[2]),
        n(a.along.x(), a.along.y(), a.along.z());
    const Eigen::Matrix3d directions =
        slides ? Eigen::Matrix3d(n * n.transpose()) : Eigen::Matrix3d::Identity();
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j)
        sum.block<3, 3>(3 * i, 3 * j) += a.stiffness * weight[i] * weight[j] * directions;
  }
  return sums;
}

/// Adds the stiffness of the actuators. Row and column are 3 particle + 0, 1 or 2 for x, y and z; the lower
/// triangle is enough. => triplets
void add_stiffness(std::span<const LinearActuator> actuators, Triplets& triplets) {
  for (const auto& on_corners : stiffness_by_corners(actuators)) {
    const Corners& corners = on_corners.first;
    const CornerStiffness& sum = on_corners.second;
    for (Eigen::Index row = 0; row < 9; ++row)
      for (Eigen::Index column = 0; column < 9; ++column) {
        const auto at = [&](Eigen::Index k) {
          return 3 * corners[static_cast<std::size_t>(k / 3)] + static_cast<int>(k % 3);
        };
        if (at(column) <= at(row) && sum(row, column) != 0.0)
          triplets.emplace_back(at(row), at(column), sum(row, column));
      }
  }
}

/// Adds the stiffness of shape memory with local frames that do not move: the force on each particle follows
/// its distance from the mean of its neighbours. => triplets
void add_stiffness(const ShapeMemory& memory, Triplets& triplets) {
  std::vector<int> particles;
  std::vector<double> weights;
  for_each_ring(memory.rings, [&](std::size_t ring, std::size_t vertex, auto neighbours) {
    particles.assign(1, static_cast<int>(vertex));
    weights.assign(1, 1.0);
    for (const Neighbour n : neighbours) {
      particles.push_back(n.particle());
      weights.push_back(-1.0 / static_cast<double>(neighbours.size()));
    }
    for (std::size_t i = 0; i < particles.size(); ++i)
      for (std::size_t j = 0; j < particles.size(); ++j)
        if (particles[j] <= particles[i])
          for (int axis = 0; axis < 3; ++axis)
            triplets.emplace_back(3 * particles[i] + axis, 3 * particles[j] + axis,
                                  memory.stiffness_weight[ring] * weights[i] * weights[j]);
  });
}

/// Returns the solution of stiffness * movement = force, [particles] m.
std::vector<Vec3d> movement(const Eigen::SimplicialLDLT<Matrix>& stiffness, std::span<const Vec3d> force) {
  Eigen::Matrix3Xd right(3, static_cast<Eigen::Index>(force.size()));
  for (std::size_t i = 0; i < force.size(); ++i)
    right.col(static_cast<Eigen::Index>(i)) << force[i].x(), force[i].y(), force[i].z();
  const Eigen::VectorXd found = stiffness.solve(right.reshaped());
  std::vector<Vec3d> result;
  for (Eigen::Index i = 0; i < found.size(); i += 3) result.push_back({found[i], found[i + 1], found[i + 2]});
  return result;
}

}  // namespace

Vec3d LinearActuator::reach(std::span<const Vec3d> position) const noexcept {
  Vec3d point;
  for (std::size_t k = 0; k < 3; ++k) point += weight[k] * position[static_cast<std::size_t>(particle[k])];
  return dot(along, along) > 0.0 ? dot(target - point, along) * along : target - point;
}

void ElasticBalance::forget_bending(std::size_t index, std::span<const Vec3d> position) {
  ShapeMemory& memory = memories_[index];
  for_each_ring(memory.rings, [&]<std::size_t Valence>(std::size_t ring, std::size_t vertex,
                                                       std::span<const Neighbour, Valence> neighbours) {
    const auto frame = local_frame<double>(RingPositions<double, Valence>{neighbours, position});
    Vec3d& offset = memory.rest_offset[ring];
    offset = {offset.x(), offset.y(), dot(position[vertex] - frame.centre, frame.n)};
  });
}

void ElasticBalance::stiffen(std::size_t index, const std::set<int>& particles, double factor) {
  ShapeMemory& memory = memories_[index];
  for (std::size_t ring = 0; ring < memory.stiffness_weight.size(); ++ring)
    if (particles.contains(memory.rings.vertex[ring])) memory.stiffness_weight[ring] *= factor;
}

double ElasticBalance::energy(std::span<const Vec3d> position,
                              std::span<const LinearActuator> actuators) const {
  double sum = 0.0;
  for (const ShapeMemory& memory : memories_)
    sum += shape_memory_energy(memory, memory.stiffness_weight, position);
  for (const LinearActuator& a : actuators) {
    const Vec3d reach = a.reach(position);
    sum += 0.5 * a.stiffness * dot(reach, reach);
  }
  return sum;
}

std::vector<Vec3d> ElasticBalance::forces(std::span<const Vec3d> position,
                                          std::span<const LinearActuator> actuators) const {
  std::vector<Vec3d> force(position.size());
  RingReactions<double> reactions;
  reactions.resize(position.size());
  for (const ShapeMemory& memory : memories_)
    add_shape_memory<double>(memory, memory.stiffness_weight, position, reactions, force);
  for (const LinearActuator& a : actuators) {
    const Vec3d pull = a.stiffness * a.reach(position);
    for (std::size_t k = 0; k < 3; ++k) force[static_cast<std::size_t>(a.particle[k])] += a.weight[k] * pull;
  }
  return force;
}

std::vector<Vec3d> ElasticBalance::relaxed(std::vector<Vec3d> position,
                                           std::span<const LinearActuator> actuators, int steps) const {
  constexpr int most_halvings = 12;
  Triplets triplets;
  for (const ShapeMemory& memory : memories_) add_stiffness(memory, triplets);
  add_stiffness(actuators, triplets);
  const auto n = 3 * static_cast<Eigen::Index>(position.size());
  Matrix stiffness(n, n);
  stiffness.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Matrix> solver(stiffness);
  if (solver.info() != Eigen::Success)
    throw InputError({}, "nothing holds a part of the trunk", "surfaces that hang together");

  double before = energy(position, actuators);
  for (int step = 0; step < steps; ++step) {
    const std::vector<Vec3d> full = movement(solver, forces(position, actuators));
    double share = 1.0;
    for (int halving = 0; halving < most_halvings; ++halving, share *= 0.5) {
      std::vector<Vec3d> trial = position;
      for (std::size_t i = 0; i < trial.size(); ++i) trial[i] += share * full[i];
      const double after = energy(trial, actuators);
      if (!(after < before)) continue;
      position = std::move(trial);
      before = after;
      break;
    }
  }
  return position;
}

}  // namespace trunk
