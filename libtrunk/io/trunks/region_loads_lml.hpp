#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/region_loads.hpp"

namespace trunk {

/// Returns the loads of an LML file. A Translation imposes the axes that have a number or NULL and leaves the
/// other axes free; NULL holds the particles at rest. An Acceleration acts on the mass of each particle. A
/// Pressure pushes on the outer side of the triangles within its targets, or along its direction if it has
/// one (our choice). Throws InputError with file and line, also for a Rotation and for a direction `toward`
/// an atom.
std::vector<RegionLoad> read_region_loads(const std::filesystem::path& path);

/// Returns the loads as an LML text in mm, N, kPa and m/s^2, units that CamiTK knows. Read back, a value
/// differs by one unit in its last place at most.
std::string region_loads_lml(const std::vector<RegionLoad>& loads);

}  // namespace trunk
