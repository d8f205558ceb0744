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

/// Builds the trunk of the paper: elastic diaphragm and abdomen, central tendon, fibres, what is fixed, and
/// (our addition) the rib cage and other rigid parts. Throws InputError on impossible sizes, factors or
/// parts.
///
/// Parameters mean the same on a finer mesh (our choice): with n the mesh's fineness, shape memory is n^2
/// times as stiff a particle, since the offset of a particle from its ring shrinks with the square of the
/// spacing while the number of particles grows with it, so that the energy of a given bending stays; mass and
/// damping are shared by n^2 times as many particles, and the muscle by n times as many fibres.
Trunk make_trunk(const TrunkMesh& mesh, const Tissue& tissue, Reaction reaction,
                 const std::vector<RigidPart>& parts = {});

/// The same from the parametric template.
Trunk make_template_trunk(const TrunkGeometry& geometry, const Tissue& tissue, Reaction reaction);

/// What `TrunkMesh::given` would have to say for this tissue: per particle, before any paralysis.
TrunkMesh::Given healthy_tissue(const TrunkMesh& mesh, const Tissue& tissue);

/// The part of a particle that belongs to a side, x to the right of the midline: 1 inside, 0 on the other
/// side, in between linearly over the 2 mm around the midline, so that 1/2 lies on it (our choice).
double share_of_side(Side side, double x);

}  // namespace trunk
