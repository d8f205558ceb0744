#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"
#include "model/model.hpp"

namespace trunk {

/// Adds the rigid parts and, where the tissue has ribs, the rib cage that is left, with the surfaces along
/// which the zone of apposition slides. The model's positions, masses and held volume must be there. Throws
/// InputError.
void add_rigid_parts(const TrunkMesh& mesh, const Tissue& tissue, const std::vector<RigidPart>& parts,
                     Model& model);

}  // namespace trunk
