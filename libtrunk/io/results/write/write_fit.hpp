#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Stores one fit and its best simulation, which is in the group `best_run` with the layout of a run. The
/// file appears completely or not at all. Throws std::runtime_error, one line, with the file and the cause.
/// Any thread may call it; simultaneous calls wait for each other.
void write_fit(const std::filesystem::path& path, const FitRecord& fit);

}  // namespace trunk
