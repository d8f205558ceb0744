#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Stores the table of a sweep: numbers and ΔV curves are copied in, the run files are linked
/// (`runs/00000` …), so that the table stays whole when run files go missing.
/// The file appears whole or not at all. Throws std::runtime_error, one line, naming file and cause.
/// May be called from any thread; calls wait for each other.
void write_sweep(const std::filesystem::path& path, const SweepRecord& sweep);

}  // namespace trunk
