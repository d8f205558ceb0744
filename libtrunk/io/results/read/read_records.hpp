#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// Returns the run of a file, or the best run of a fit. Clock times may be missing. Throws InputError if the
/// file is neither, or if it is damaged.
RunRecord read_run(const std::filesystem::path& path);

/// Returns the fit of a file; throws InputError if the file is not a fit, or if it is damaged.
FitRecord read_fit(const std::filesystem::path& path);

/// Returns why a fit withholds its results; none if the file is not a fit. Throws InputError if it is
/// damaged.
std::vector<FitRecord::Gate> read_gates(const std::filesystem::path& path);

/// Returns the draws that a fit keeps; none in a file of version 1. Throws as read_fit does.
FitRecord::Draws read_draws(const std::filesystem::path& path);

}  // namespace trunk
