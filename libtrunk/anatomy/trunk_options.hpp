#pragma once

#include <string>

#include "errors/input_error.hpp"
#include "model/model.hpp"

namespace trunk {

/// Sizes of the parametric trunk, m and m3. The defaults come from the paper's Table 1 where possible
/// (apposition_length, end_expiratory_volume, and half_width x half_depth from 466 ml over 9.13 mm). All
/// others are our choice from adult anatomy.
struct TrunkGeometry {
  double half_width = 0.160;
  double half_depth = 0.105;
  double abdomen_height = 0.200;     // pelvic floor to costal insertion
  double apposition_length = 0.149;  // costal insertion to top of the zone of apposition
  double dome_height_right = 0.070;  // top of the zone of apposition to the right dome
  double dome_height_left = 0.070;
  double end_expiratory_volume = 4760e-6;
  double tendon_border_size = 0.79;  // of the half-axes, at the border of the central tendon
  int resolution = 1;                // particles along a length, relative to the 113-particle mesh
};

enum class Side { none, right, left, both };

/// Where the muscle fibres end. They begin at the costal insertion.
///  - tendon_border: at the border of the central tendon (our choice, the default). In the paper's
///    introduction the tendon "originates the muscular fibers", and these fibres reproduce the measured
///    change of shape.
///  - apposition_top: at the top of the zone of apposition (the paper's model: "vertical and along the zone
///    of apposition").
enum class FibreEnd { tendon_border, apposition_top };

/// What shares the damping.
///  - particle: every particle has c, or c / n^2 on a mesh n times as fine.
///  - area: a particle has c times the surface around it (a third of each triangle), over the mean of the 113
///    particles of the template. It does not depend on the triangles (our choice).
enum class DampingBy { particle, area };

/// How the stiffness of a particle follows from the mesh.
///  - ring: the paper's. All rings are alike, and results depend on how the mesh is triangulated.
///  - sheet: that of a thin sheet, which the triangles do not change (our choice; libtrunk/sheet/README.md).
enum class ElasticLaw { ring, sheet };

/// The properties of tissue, muscle and skeleton that are not fitted.
struct Tissue {
  double particle_mass = 0.2;  // kg; our choice
  DampingBy damping = DampingBy::particle;
  ElasticLaw elasticity = ElasticLaw::ring;
  double tendon_factor = 2.0;  // stiffness of the central tendon over that of the rest (paper)
  FibreEnd fibre_end = FibreEnd::tendon_border;
  bool ribs = true;  // a rigid rib cage carries the costal insertion and keeps the zone of apposition inside
  double rib_friction = 0.0;        // Coulomb's coefficient between the ribs and the zone of apposition
  double membrane_stiffness = 0.0;  // N/m, of a spring along every edge of abdomen and diaphragm (our option)
  /// Factor on the elasticity of held particles of the elastic surface (our option). The ring of a held
  /// particle clamps the surface only half a spacing outside of the particle, an error of first order in the
  /// spacing. A factor of 2 corrects this, and results then converge nearly twice as fast.
  /// A sheet finds the factor of each particle, and does not use this one.
  double held_stiffness = 1.0;
  Side paralysed = Side::none;
  double paralysed_stiffness = 0.5;  // elasticity of a paralysed hemidiaphragm over the healthy one
};

/// A part of the trunk as a rigid component, named by region or landmark. With ribs, all particles of the
/// costal insertion and the lung wall that are in no part form one fixed body, the rib cage. Its surface
/// faces the zone of apposition.
struct RigidPart {
  std::string region;  // the particles that it carries
  RigidBody::Motion motion = RigidBody::Motion::fixed;
  ImposedMotion imposed;
  std::string surface_for;  // region whose particles slide along its surface; empty: none
  Place at;                 // in the user's file, for messages
};

}  // namespace trunk
