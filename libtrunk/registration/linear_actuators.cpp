#include "registration/linear_actuators.hpp"

#include <Eigen/SparseCholesky>
#include <memory>

#include "errors/input_error.hpp"
#include "forces/shape_memory.hpp"

namespace trunk {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// The stiffness of what draws a weighted sum of particles, lower triangle. => triplets
void add_stiffness(std::span<const int> particles, std::span<const double> weights, double stiffness,
                   Triplets& triplets) {
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = 0; j < particles.size(); ++j)
      if (particles[j] <= particles[i] && weights[i] * weights[j] != 0.0)
        triplets.emplace_back(particles[i], particles[j], stiffness * weights[i] * weights[j]);
}

/// Of shape memory while its local frames stand still: each particle is drawn by what it is off the mean of
/// its neighbours.
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
    add_stiffness(particles, weights, memory.stiffness_weight[ring], triplets);
  });
}

/// Solves stiffness * movement = force. [particles] m
std::vector<Vec3d> movement(const Eigen::SimplicialLDLT<Matrix>& stiffness, std::span<const Vec3d> force) {
  Eigen::MatrixX3d right(static_cast<Eigen::Index>(force.size()), 3);
  for (std::size_t i = 0; i < force.size(); ++i)
    right.row(static_cast<Eigen::Index>(i)) << force[i].x(), force[i].y(), force[i].z();
  const Eigen::MatrixX3d found = stiffness.solve(right);
  std::vector<Vec3d> result;
  for (Eigen::Index i = 0; i < found.rows(); ++i) result.push_back({found(i, 0), found(i, 1), found(i, 2)});
  return result;
}

}  // namespace

Vec3d LinearActuator::reach(std::span<const Vec3d> position) const noexcept {
  Vec3d point;
  for (std::size_t k = 0; k < 3; ++k) point += weight[k] * position[static_cast<std::size_t>(particle[k])];
  return target - point;
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
  for (const LinearActuator& a : actuators) add_stiffness(a.particle, a.weight, a.stiffness, triplets);
  const auto n = static_cast<Eigen::Index>(position.size());
  Matrix stiffness(n, n);
  stiffness.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Matrix> solver(stiffness);
  if (solver.info() != Eigen::Success)
    throw InputError("a part of the trunk is held by nothing: its surfaces have to hang together");

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
