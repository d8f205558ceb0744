#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/region_loads.hpp"

namespace trunk {

/// The loads of an LML file. A Translation imposes the axes that have a number or NULL (NULL: at their rest
/// place) and leaves the absent ones free; an Acceleration acts on each particle's mass; a Pressure pushes
/// against the outer side of the triangles within its targets, or with a direction along that (our choice).
/// Throws InputError with file and line; a Rotation and a direction `toward` an atom are refused.
std::vector<RegionLoad> read_region_loads(const std::filesystem::path& path);

/// The same loads as an LML text.
std::string region_loads_lml(const std::vector<RegionLoad>& loads);

}  // namespace trunk
