#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/piecewise_linear.hpp"
#include "math/vec3.hpp"
#include "mesh/fans.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// How the neighbours balance the force of a shape-memory actuator.
///  - variational: all forces are the negative gradient of E = 1/2 k |P - T|^2 (our choice, the default).
///    This conserves linear and angular momentum, and energy if nothing damps.
///  - published: the neighbours share -F equally, as the paper says. This conserves linear momentum only.
enum class Reaction { variational, published };

/// The elastic particles: the rest shape of each one-ring, and its stiffness.
struct ShapeMemory {
  Reaction reaction = Reaction::variational;
  RingTable rings;
  RingTable receiving;                   // the rings around the particles that a force can move
  std::vector<Vec3d> rest_offset;        // [rings] m, P - G at rest in the local frame (u, v, n)
  std::vector<double> stiffness_weight;  // [rings] times k_elasticity; 2 in the central tendon
  std::vector<double> abdominal_share;   // [rings] 0 to 1: how much the abdominal stiffness factor applies
  /// How much more than 1/m each neighbour weighs in the centre G of its ring; empty: all weigh 1/m. With
  /// weights, the reaction is variational.
  std::vector<double> extra_weight;  // [as rings.neighbour]
  std::vector<double>
      extra_received;  // [as receiving.neighbour] that of the particle in its neighbour's ring
};

/// A muscle fibre: an actuator of zero rest length between two particles. Its stiffness is A(t) k_muscle
/// activity.
struct Fibre {
  int insertion, origin;
  /// Share of k_muscle: 1 for a healthy fibre (less on finer meshes, which have more fibres), 0 if paralysed.
  double activity;
};

/// How a driven rigid component moves: it turns by angle(t) around an axis and then shifts.
struct ImposedMotion {
  Vec3d point, axis;      // m, unit vector: the axis passes through the point
  PiecewiseLinear angle;  // rad, counter-clockwise seen from the tip of the axis; empty: 0
  Vec3d direction;        // of the shift
  PiecewiseLinear shift;  // m; empty: 0
};

/// A rigid component (paper, "Model"): a body with six degrees of freedom. The particles that it carries keep
/// their places in it. `carry` makes it.
struct RigidBody {
  enum class Motion { fixed, driven, free };
  std::string name;
  Motion motion = Motion::fixed;
  std::vector<int> particles;  // carried
  ImposedMotion imposed;       // driven only

  // derived from the carried particles, for free bodies only
  Vec3d centre;                 // m, centre of mass at rest; a driven body has the point of its axis here
  double mass = 0.0;            // kg
  double damping_weight = 0.0;  // times the damping coefficient
  Vec3d inverse_inertia[3];     // 1/(kg m2), rows, at rest, about the centre
  std::vector<int> held_rows;   // rings of the held volume whose vertex it carries
};

/// The surface of a rigid body opposite one particle, to second order about a point of the surface. Let y be
/// the place of the particle in the body's rest frame, relative to that point. Then
/// normal . y + 1/2 y . (curvature y) <= 0 is inside.
struct Support {
  int particle;
  int body;  // of Model::bodies, fixed or driven
  Vec3d point, normal;
  Vec3d curvature[3];  // 1/m, rows, symmetric, tangential; positive if the body is hollow there
};

/// The force direction * magnitude(t), N, on one particle.
struct FocalForce {
  int particle;
  Vec3d direction;
  PiecewiseLinear magnitude;
};

/// The displacement from rest direction * magnitude(t), m. It is imposed on one particle along `axes`
/// (1: imposed, 0: free).
struct ImposedDisplacement {
  int particle;
  Vec3d axes, direction;
  PiecewiseLinear magnitude;
};

/// A pressure on triangles, Pa, from the side that they face. It follows them as they move.
struct PressureLoad {
  std::vector<Triangle> triangles;
  PiecewiseLinear magnitude;
};

/// A spring between two neighbouring particles of a surface.
struct MembraneEdge {
  int a, b;
  double rest_length;  // m
  double stiffness;    // N/m
};

/// A closed surface. The volume that it encloses follows rest * target(t) exactly.
struct HeldVolume {
  std::vector<Triangle> triangles;
  RingTable rings;
  RingTable fans;          // of the triangles
  double rest = 0.0;       // m3
  PiecewiseLinear target;  // fraction of rest; empty: 1 at all times
};

/// The lung and the airway between the mouth and the pleura (our addition). With V the lung volume, its
/// pleural pressure is airway_pressure - E_L (V - V at rest) - (R + tube_resistance) V', as a change from
/// relaxation. E_L and R are Parameters.
struct Pleura {
  PiecewiseLinear
      airway_pressure;           // Pa, above that of the air around, at the outer end of the tube; empty: 0
  double tube_resistance = 0.0;  // Pa s/m3
};

/// How a trunk springs back (see measure_recoil). Its volume is close to that of one compartment,
/// tau V' + V = gain (k_muscle / k_elasticity) A(t), with tau = time_factor damping / k_elasticity. This is
/// the tissue alone. With eps the elastance, k = k_elasticity, c the damping and a lung of E_L and R, (eps
/// time_factor c + R) V' + (eps k + E_L) V = eps gain k_muscle A(t) + airway pressure.
struct Recoil {
  double time_factor = 0.0;     // a pure number
  double gain = 0.0;            // m3
  double memory = 0.0;          // of what was before, a time in damping / k_elasticity
  double abdomen_factor = 0.0;  // for which all this holds
  double elastance = 0.0;       // 1/m4: Pa/m3 of pleural pressure per N/m of k_elasticity; 0: not measured
  double abdominal = 0.0;       // 1/m4: Pa/m3 of abdominal pressure per N/m of k_elasticity
};

/// The particles at the top of both domes of the diaphragm: what ultrasound follows.
struct Domes {
  std::vector<int> right, left;
};

/// Everything that stays constant during a simulation and between the runs of a fit. All values are in SI
/// units.
struct Model {
  std::vector<Vec3d> rest;             // [particles] m
  std::vector<double> mass;            // [particles] kg
  std::vector<double> damping_weight;  // [particles] times the damping coefficient
  std::vector<Vec3d> mobility;         // [particles] per axis 1: free; 0: held, imposed or in a rigid body
  Vec3d gravity;                       // m/s2
  ShapeMemory shape_memory;
  std::vector<Fibre> fibres;
  HeldVolume abdomen;
  std::vector<MembraneEdge> membrane;  // empty: a flat patch does not resist stretch (the paper's law)
  std::vector<RigidBody> bodies;
  std::vector<Support> supports;
  double friction = 0.0;  // Coulomb's coefficient between supports and their particles
  std::vector<FocalForce> focal_forces;
  std::vector<ImposedDisplacement> imposed_displacements;
  std::vector<PressureLoad> pressures;
  std::vector<Triangle> lung;  // closed
  RingTable lung_rings, lung_fans;
  std::optional<Pleura> pleura;  // nothing: the lung's volume is measured and has no effect
  Domes domes;
  std::optional<Recoil> recoil;  // measured if breathing repeats

  std::size_t particles() const noexcept { return rest.size(); }
};

/// Adds a rigid body that carries `body.particles`, and derives its mass, centre and inertia. The model's
/// masses and held volume have to be there. Throws InputError if a particle does not exist or has a body
/// already, if a body that moves carries no particle, or if the particles of a free body lie on a line.
void carry(RigidBody body, Model& model);

/// Returns true for each particle that forces can move: it has a free axis, or a free body carries it.
/// [particles]
std::vector<bool> pushed_particles(const Model& model);

/// Returns true for each particle that forces, a driven body or an imposed displacement can move. [particles]
std::vector<bool> moving_particles(const Model& model);

/// Consecutive numbers from `first` up to, but not including, `last`.
struct HalfOpenRange {
  std::size_t first, last;
};

/// Returns the numbers for which a mask is true, as ranges.
std::vector<HalfOpenRange> ranges(const std::vector<bool>& mask);

/// Calls visit(number) for all numbers of the ranges.
template <class Visit>
[[gnu::always_inline]] inline void for_all(const std::vector<HalfOpenRange>& ranges, Visit&& visit) noexcept {
  for (const auto& [first, last] : ranges)
    for (std::size_t i = first; i < last; ++i) visit(i);
}

/// Fans that move, since something can move one of their particles, and fans that never do.
struct MovingAndStill {
  RingTable moving, still;
};
/// Returns fans parted by motion.
MovingAndStill by_motion(const RingTable& fans, const Model& model);

/// Returns the constraint that holds the volume that a surface encloses at rest. rest: [particles] m.
HeldVolume held_volume(const Surface& surface, std::span<const Vec3d> rest);

/// Throws InputError unless sizes agree, indices exist, numbers are finite, masses are positive, weights are
/// not negative and both surfaces enclose a positive volume. The error says what is wrong.
void require_valid(const Model& model);

}  // namespace trunk
