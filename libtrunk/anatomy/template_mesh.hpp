#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"

namespace trunk {

/// Returns the parametric trunk: rings of particles around ellipses. Resolution 1 has 113 particles in rings
/// of 12. At resolution r, every ring and every interval between rings has r times as many, on the same
/// smooth shape. The height of the lung follows from the end-expiratory volume. The trunk is mirror symmetric
/// about x = 0 if both domes are equally high. Throws InputError if a size is not above 0, if the resolution
/// is not 1 to 16, or if the sizes leave no room for the lung.
TrunkMesh make_template_mesh(const TrunkGeometry& geometry);

}  // namespace trunk
