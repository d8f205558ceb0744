#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Stores one simulation: H5MD 1.1 for the trajectory, CF units and netCDF-4 dimensions throughout. The file
/// appears completely or not at all. Throws std::runtime_error, one line, with the file and the cause. Any
/// thread may call it; simultaneous calls wait for each other.
void write_run(const std::filesystem::path& path, const RunRecord& run);

}  // namespace trunk
