#pragma once

#include <filesystem>

#include "anatomy/trunk_mesh.hpp"

namespace trunk {

TrunkMesh read_trunk_pml(const std::filesystem::path& path);

}  // namespace trunk
