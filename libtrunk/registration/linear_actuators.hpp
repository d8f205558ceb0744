#pragma once

#include <array>
#include <set>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace trunk {

/// A linear actuator (paper: F = k (P_target - P)) that pulls a weighted mean of up to three particles: a
/// point of a triangle or, with the weights (1, 0, 0), one particle.
struct LinearActuator {
  std::array<int, 3> particle;
  std::array<double, 3> weight;
  Vec3d target;      // m
  double stiffness;  // N/m
  /// If it has unit length, the actuator pulls along this direction only, and the point slides across it. If
  /// it is zero, the actuator pulls in all directions.
  Vec3d along{};

  /// Returns the way from the point to its target, m. position: [particles] m.
  Vec3d reach(std::span<const Vec3d> position) const noexcept;
};

/// The balance of elastic surfaces and linear actuators.
class ElasticBalance {
 public:
  /// Adds an elastic surface by its shape memory, which has the simulator's own forces and energy. Its
  /// reaction has to be variational. Its weights are its stiffness, N/m.
  void add(ShapeMemory memory) { memories_.push_back(std::move(memory)); }

  /// Makes a shape memory take the distances of particles from the plane of their neighbours at `position` as
  /// those at rest. It then resists only shear and uneven stretch within the surface.
  void forget_bending(std::size_t memory, std::span<const Vec3d> position);

  /// Makes the rings of these particles stiffer.
  void stiffen(std::size_t memory, const std::set<int>& particles, double factor);

  /// Returns the positions some steps nearer to the balance of all forces than `position`: [particles] m.
  /// Each step solves a sparse linear system: it would balance the forces if the local frames of shape memory
  /// did not move. A step is shortened until the energy falls. Throws InputError if nothing holds a particle.
  std::vector<Vec3d> relaxed(std::vector<Vec3d> position, std::span<const LinearActuator> actuators,
                             int steps) const;

 private:
  double energy(std::span<const Vec3d> position, std::span<const LinearActuator> actuators) const;
  std::vector<Vec3d> forces(std::span<const Vec3d> position, std::span<const LinearActuator> actuators) const;

  std::vector<ShapeMemory> memories_;
};

}  // namespace trunk
