#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Stores one fit, its best simulation included (group `best_run`, laid out as a run file).
/// The file appears whole or not at all. Throws std::runtime_error, one line, naming file and cause.
/// May be called from any thread; calls wait for each other.
void write_fit(const std::filesystem::path& path, const FitRecord& fit);

}  // namespace trunk
