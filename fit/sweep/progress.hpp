#pragma once

#include <cstddef>
#include <filesystem>

namespace trunk {

/// How many runs of a sweep are done.
struct SweepProgress {
  std::size_t runs = 0, done = 0, failed = 0;
  double runs_per_s = 0.0;  // over the last minute of work; 0: unknown
  bool has_table = false;
};

/// Returns the progress of a folder, also while processes work in it. Throws InputError if it holds no sweep.
SweepProgress progress_of(const std::filesystem::path& folder);

}  // namespace trunk
