#pragma once

#include <string>

#include "errors/input_error.hpp"
#include "model/model.hpp"

namespace trunk {

/// Sizes of the parametric trunk, m and m3. The defaults are derived from the paper's Table 1 where it tells
/// (apposition_length, end_expiratory_volume, and half_width x half_depth from 466 ml over 9.13 mm); the rest
/// is our choice from adult anatomy.
struct TrunkGeometry {
  double half_width = 0.160;
  double half_depth = 0.105;
  double abdomen_height = 0.200;     // pelvic floor to costal insertion
  double apposition_length = 0.149;  // costal insertion to top of the zone of apposition
  double dome_height_right = 0.070;  // top of the zone of apposition to the right dome
  double dome_height_left = 0.070;
  double end_expiratory_volume = 4760e-6;
  int resolution = 1;  // particles along a length, times those of the 113-particle mesh
};

enum class Side { none, right, left, both };

/// Where the muscle fibres end; they begin at the costal insertion.
///  - tendon_border: the border of the central tendon (the paper's introduction: the tendon "originates the
///    muscular fibers", inserted on the ribs). Our choice, the default: it reproduces the measured shape
///    change.
///  - apposition_top: the top of the zone of apposition (the paper's model: "vertical and along the zone of
///    apposition").
enum class FibreEnd { tendon_border, apposition_top };

/// Everything about tissue, muscle and skeleton that is not a fitted parameter.
struct Tissue {
  double particle_mass = 0.2;  // kg; our choice
  double tendon_factor = 2.0;  // stiffness of the central tendon over the other diaphragm (paper)
  FibreEnd fibre_end = FibreEnd::tendon_border;
  bool ribs = true;           // costal insertion carried, zone of apposition kept inside, by a rigid rib cage
  double rib_friction = 0.0;  // Coulomb's coefficient between the ribs and the zone of apposition
  double membrane_stiffness =
      0.0;  // N/m of a spring along every edge of the abdomen and diaphragm (our option)
  /// Elasticity of the particles of the elastic surface that are held, times their own (our option). The
  /// energy of a held particle's ring lets the surface be clamped only half a spacing outside it, an error of
  /// first order in the spacing; 2 makes up for it, and results then converge nearly twice as fast.
  double held_stiffness = 1.0;
  Side paralysed = Side::none;
  double paralysed_stiffness = 0.5;  // elasticity left in a paralysed hemidiaphragm, times the healthy one
};

/// A part of the trunk as a rigid component, named by region or landmark. With ribs, what no part claims of
/// the costal insertion and the lung wall is one fixed body, the rib cage, whose surface faces the zone of
/// apposition.
struct RigidPart {
  std::string region;  // what it carries
  RigidBody::Motion motion = RigidBody::Motion::fixed;
  ImposedMotion imposed;
  std::string surface_for;  // region of the particles that slide along its surface; empty: none
  Place at;                 // in the user's file, for messages
};

}  // namespace trunk
