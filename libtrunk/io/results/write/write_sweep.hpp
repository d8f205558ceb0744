#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Stores the table of a sweep. Numbers and ΔV curves are copied into it, so that it stays complete if run
/// files are lost. The run files are linked as `runs/00000` …. The file appears completely or not at all.
/// Throws std::runtime_error, one line, with the file and the cause. Any thread may call it; simultaneous
/// calls wait for each other.
void write_sweep(const std::filesystem::path& path, const SweepRecord& sweep);

}  // namespace trunk
