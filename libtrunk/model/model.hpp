#pragma once

#include <string>
#include <vector>

#include "math/piecewise_linear.hpp"
#include "math/vec3.hpp"
#include "mesh/surface.hpp"
#include "mesh/volume.hpp"

namespace trunk {

/// How the force of a shape-memory actuator is balanced by its neighbours.
///  - variational: all forces are the negative gradient of E = 1/2 k |P - T|^2 (our choice, the default).
///    Conserves linear and angular momentum, and energy where nothing damps.
///  - published: the neighbours share -F equally, as the paper says. Conserves linear momentum only.
enum class Reaction { variational, published };

/// The elastic particles: what each remembers of its one-ring, and how stiffly.
struct ShapeMemory {
  Reaction reaction = Reaction::variational;
  RingTable rings;
  std::vector<Vec3d> rest_offset;        // [rings] m, P - G at rest in the local frame (u, v, n)
  std::vector<double> stiffness_weight;  // [rings] times k_elasticity; the central tendon has 2
  std::vector<double> abdominal_share;   // [rings] 0..1: how much the abdominal stiffness factor applies
};

/// A muscle fibre: an actuator of zero rest length between two particles, the stiffness A(t) k_muscle
/// activity.
struct Fibre {
  int insertion, origin;
  double activity;  // 1 healthy, 0 paralysed
};

/// A plane of the rib cage that one particle may touch but not cross: normal . x <= offset. `push` moves the
/// particle back along the axes it is free to move on; normal . push = 1.
struct Support {
  int particle;
  int ring;  // of the held surface, the row of `particle`
  Vec3d normal, push;
  double offset;
};

/// Force direction * magnitude(t), N, on one particle.
struct FocalForce {
  int particle;
  Vec3d direction;
  PiecewiseLinear magnitude;
};

/// Displacement from rest, direction * magnitude(t), m, imposed on one particle along `axes` (1 imposed, 0
/// not).
struct ImposedDisplacement {
  int particle;
  Vec3d axes, direction;
  PiecewiseLinear magnitude;
};

/// A closed surface whose enclosed volume follows rest * target(t) exactly.
struct HeldVolume {
  std::vector<Triangle> triangles;
  RingTable rings;
  double rest = 0.0;       // m3
  PiecewiseLinear target;  // fraction of rest; empty: 1 at all times
};

/// All that stays constant during a simulation and between the runs of a fit. SI units.
struct Model {
  std::vector<Vec3d> rest;             // [particles] m
  std::vector<double> mass;            // [particles] kg
  std::vector<double> damping_weight;  // [particles] times the damping coefficient
  std::vector<Vec3d> mobility;         // [particles] per axis 1 free, 0 held (null or imposed displacement)
  Vec3d gravity;                       // m/s2
  ShapeMemory shape_memory;
  std::vector<Fibre> fibres;
  HeldVolume abdomen;
  std::vector<Support> supports;
  std::vector<FocalForce> focal_forces;
  std::vector<ImposedDisplacement> imposed_displacements;
  std::vector<Triangle> lung;  // closed, measured only

  std::size_t particles() const noexcept { return rest.size(); }
};

/// Throws InputError, naming what is wrong, unless sizes agree, indices exist, numbers are finite, masses are
/// positive, weights are not negative and both surfaces enclose a positive volume.
void require_valid(const Model& model);

}  // namespace trunk
