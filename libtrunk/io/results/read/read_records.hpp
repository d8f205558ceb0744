#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// A run as it was written, or the best run of a fit. Clock times may be absent. Throws InputError when the
/// file is neither, or damaged.
RunRecord read_run(const std::filesystem::path& path);

/// A fit as it was written. Throws InputError when the file is none, or damaged.
FitRecord read_fit(const std::filesystem::path& path);

}  // namespace trunk
