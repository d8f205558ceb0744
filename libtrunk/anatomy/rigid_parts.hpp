#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"
#include "model/model.hpp"

namespace trunk {

/// Adds the rigid parts, the rib cage if the tissue has ribs, and the surfaces along which the zone of
/// apposition slides. The model's positions, masses and held volume have to be there. Throws InputError, with
/// the place of the part, if a region is not there, if a particle has two bodies or surfaces, if a free part
/// has a surface, lies on a line or carries particles that slide along the ribs, or if a particle cannot
/// slide. => bodies, supports, friction
void add_rigid_parts(const TrunkMesh& mesh, const Tissue& tissue, const std::vector<RigidPart>& parts,
                     Model& model);

}  // namespace trunk
