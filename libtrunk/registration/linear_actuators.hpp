#pragma once

#include <array>
#include <set>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace trunk {

/// A linear actuator (paper: F = k (P_target - P)) that draws a weighted mean of up to three particles: a
/// point of a triangle, or with weights (1, 0, 0) one particle.
struct LinearActuator {
  std::array<int, 3> particle;
  std::array<double, 3> weight;
  Vec3d target;      // m
  double stiffness;  // N/m
  /// Of unit length: it draws along this alone, and the point slides across it. Zero: it draws all ways.
  Vec3d along{};

  /// From where the point is to where it is drawn, m.
  Vec3d reach(std::span<const Vec3d> position) const noexcept;
};

/// What elastic surfaces and linear actuators do together.
class ElasticBalance {
 public:
  /// Adds an elastic surface by its shape memory, of variational reaction: the simulator's own forces and
  /// energy. Its weights are its stiffness, N/m.
  void add(ShapeMemory memory) { memories_.push_back(std::move(memory)); }

  /// Lets a shape memory forget how far particles lie out of the plane of their neighbours, as they do at
  /// `position`: what it still resists is shear and uneven stretch within the surface.
  void forget_bending(std::size_t memory, std::span<const Vec3d> position);

  /// Makes the rings of these particles stiffer.
  void stiffen(std::size_t memory, const std::set<int>& particles, double factor);

  /// Goes some steps toward the balance of all forces, from `position`: [particles] m. Each step is the one
  /// that would balance them if the local frames of shape memory stood still, one sparse linear system, cut
  /// back until the energy falls. Throws InputError where a particle is held by nothing.
  std::vector<Vec3d> relaxed(std::vector<Vec3d> position, std::span<const LinearActuator> actuators,
                             int steps) const;

 private:
  double energy(std::span<const Vec3d> position, std::span<const LinearActuator> actuators) const;
  std::vector<Vec3d> forces(std::span<const Vec3d> position, std::span<const LinearActuator> actuators) const;

  std::vector<ShapeMemory> memories_;
};

}  // namespace trunk
