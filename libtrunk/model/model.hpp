#pragma once

#include <string>
#include <vector>

#include "math/piecewise_linear.hpp"
#include "math/vec3.hpp"
#include "mesh/fans.hpp"
#include "mesh/surface.hpp"

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
  RingTable receiving;                   // the rings around particles that a force can move
  std::vector<Vec3d> rest_offset;        // [rings] m, P - G at rest in the local frame (u, v, n)
  std::vector<double> stiffness_weight;  // [rings] times k_elasticity; the central tendon has 2
  std::vector<double> abdominal_share;   // [rings] 0..1: how much the abdominal stiffness factor applies
};

/// A muscle fibre: an actuator of zero rest length between two particles, the stiffness A(t) k_muscle
/// activity.
struct Fibre {
  int insertion, origin;
  double
      activity;  // share of k_muscle: 1 healthy (less on finer meshes, which have more fibres), 0 paralysed
};

/// How a rigid component moves when it is driven: turned by angle(t) around an axis, then shifted.
struct ImposedMotion {
  Vec3d point, axis;      // m, unit vector: the axis passes through the point
  PiecewiseLinear angle;  // rad, counter-clockwise seen from the tip of the axis; empty: 0
  Vec3d direction;        // of the shift
  PiecewiseLinear shift;  // m; empty: 0
};

/// A rigid component (paper, "Model"), a body of six degrees of freedom: the particles it carries keep their
/// places in it. Made by `carry`.
struct RigidBody {
  enum class Motion { fixed, driven, free };
  std::string name;
  Motion motion = Motion::fixed;
  std::vector<int> particles;  // carried
  ImposedMotion imposed;       // driven only

  // derived from the carried particles; of free bodies only
  Vec3d centre;                 // m, centre of mass at rest; of driven ones the point of the axis
  double mass = 0.0;            // kg
  double damping_weight = 0.0;  // times the damping coefficient
  Vec3d inverse_inertia[3];     // 1/(kg m2), rows, at rest, about the centre
  std::vector<int> held_rows;   // rings of the held volume whose vertex it carries
};

/// The surface of a rigid body opposite one particle, to second order about a point of it: with y the place
/// of the particle in the body's rest frame relative to that point, normal . y + 1/2 y . (curvature y) <= 0
/// is inside.
struct Support {
  int particle;
  int body;  // of Model::bodies, fixed or driven
  Vec3d point, normal;
  Vec3d curvature[3];  // 1/m, rows, symmetric, tangential; positive where the body is hollow
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

/// A pressure on triangles, Pa, from the side they face; it follows them as they move.
struct PressureLoad {
  std::vector<Triangle> triangles;
  PiecewiseLinear magnitude;
};

/// A spring between two neighbours of a surface, at rest at its rest length.
struct MembraneEdge {
  int a, b;
  double rest_length;  // m
  double stiffness;    // N/m
};

/// A closed surface whose enclosed volume follows rest * target(t) exactly.
struct HeldVolume {
  std::vector<Triangle> triangles;
  RingTable rings;
  RingTable fans;          // of the triangles
  double rest = 0.0;       // m3
  PiecewiseLinear target;  // fraction of rest; empty: 1 at all times
};

/// All that stays constant during a simulation and between the runs of a fit. SI units.
struct Model {
  std::vector<Vec3d> rest;             // [particles] m
  std::vector<double> mass;            // [particles] kg
  std::vector<double> damping_weight;  // [particles] times the damping coefficient
  std::vector<Vec3d> mobility;  // [particles] per axis 1 free, 0 held, imposed or carried by a rigid body
  Vec3d gravity;                // m/s2
  ShapeMemory shape_memory;
  std::vector<Fibre> fibres;
  HeldVolume abdomen;
  std::vector<MembraneEdge>
      membrane;  // empty: no resistance to stretch within a flat patch (the paper's law)
  std::vector<RigidBody> bodies;
  std::vector<Support> supports;
  double friction = 0.0;  // Coulomb's coefficient between supports and their particles
  std::vector<FocalForce> focal_forces;
  std::vector<ImposedDisplacement> imposed_displacements;
  std::vector<PressureLoad> pressures;
  std::vector<Triangle> lung;  // closed, measured only
  RingTable lung_fans;

  std::size_t particles() const noexcept { return rest.size(); }
};

/// Adds a rigid body that carries `body.particles` and derives what follows from them. The model's masses,
/// held volume and supports must be there. Throws InputError where a particle is carried twice, or a free
/// body's particles lie on a line or bear a support.
void carry(RigidBody body, Model& model);

/// True for the particles that forces can move: not held along all axes, or carried by a free body.
std::vector<bool> pushed_particles(const Model& model);

/// True for the particles that something can move: forces, a body that is driven, or an imposed displacement.
std::vector<bool> moving_particles(const Model& model);

/// Numbers one after the other, [first, last).
struct HalfOpenRange {
  std::size_t first, last;
};

/// Where a mask holds.
std::vector<HalfOpenRange> ranges(const std::vector<bool>& mask);

/// Calls visit(number) for all of them.
template <class Visit>
[[gnu::always_inline]] inline void for_all(const std::vector<HalfOpenRange>& ranges, Visit&& visit) noexcept {
  for (const auto& [first, last] : ranges)
    for (std::size_t i = first; i < last; ++i) visit(i);
}

/// Fans of which something moves a particle, and those that stay as they are.
struct MovingAndStill {
  RingTable moving, still;
};
MovingAndStill by_motion(const RingTable& fans, const Model& model);

/// The volume that a surface encloses at rest, to be held.
HeldVolume held_volume(const Surface& surface, std::span<const Vec3d> rest);

/// Throws InputError, naming what is wrong, unless sizes agree, indices exist, numbers are finite, masses are
/// positive, weights are not negative and both surfaces enclose a positive volume.
void require_valid(const Model& model);

}  // namespace trunk
