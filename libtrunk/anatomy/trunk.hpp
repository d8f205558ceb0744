#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"
#include "model/model.hpp"

namespace trunk {

/// A trunk ready to be simulated and measured: the model and the anatomical names of its particles.
struct Trunk {
  Model model;
  TrunkMesh mesh;
};

/// Returns the trunk of the paper: elastic diaphragm and abdomen, central tendon, fibres, fixed particles,
/// and (our addition) the rib cage and other rigid parts. Throws InputError if the mesh, a factor or a part
/// is impossible.
///
/// Parameters mean the same on a finer mesh (our choice). Let n be the mesh's fineness. Shape memory is n^2
/// times as stiff at each particle: the offset of a particle from its ring shrinks with the square of the
/// spacing, while the number of particles grows with it, so that the energy of a given bending stays. n^2
/// times as many particles share mass and damping, and n times as many fibres share the muscle. With
/// ElasticLaw::sheet, stiffness, damping and muscle go by areas and widths instead.
Trunk make_trunk(const TrunkMesh& mesh, const Tissue& tissue, Reaction reaction,
                 const std::vector<RigidPart>& parts = {});

/// Returns the same for the parametric template.
Trunk make_template_trunk(const TrunkGeometry& geometry, const Tissue& tissue, Reaction reaction);

/// Returns mass, stiffness and damping of each particle, and the strength of a fibre, before any paralysis.
/// What the mesh gives for single particles comes before the tissue.
TrunkMesh::Given healthy_tissue(const TrunkMesh& mesh, const Tissue& tissue);

/// Returns the share of a particle that belongs to a side, if it lies x m to the right of the midline: 1
/// inside, 0 on the other side. Within 1 mm of the midline the share is linear in x, and on it 1/2 (our
/// choice).
double share_of_side(Side side, double x);

}  // namespace trunk
