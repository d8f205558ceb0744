#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Stores one simulation: H5MD 1.1 for the trajectory, CF units and netCDF-4 dimensions throughout.
/// The file appears whole or not at all. Throws std::runtime_error, one line, naming file and cause.
/// May be called from any thread; calls wait for each other.
void write_run(const std::filesystem::path& path, const RunRecord& run);

}  // namespace trunk
