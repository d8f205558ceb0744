#pragma once

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"

namespace trunk {

/// Builds the parametric trunk: rings of particles around ellipses. Resolution 1 has 113 particles, rings of
/// 12; at resolution r every ring and every interval between rings has r times as many, on the same smooth
/// shape. The height of the lung follows from the end-expiratory volume. Mirror symmetric about x = 0 where
/// both domes are equally high. Throws InputError where the sizes leave no room for the lung.
TrunkMesh make_template_mesh(const TrunkGeometry& geometry);

}  // namespace trunk
