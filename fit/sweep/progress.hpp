#pragma once

#include <cstddef>
#include <filesystem>

namespace trunk {

/// How far a folder is; anyone may look at any time. Throws InputError where it holds no sweep.
struct SweepProgress {
  std::size_t runs = 0, done = 0, failed = 0;
  double runs_per_s = 0.0;  // over the last minute of work; 0: not known
  bool has_table = false;
};
SweepProgress progress_of(const std::filesystem::path& folder);

}  // namespace trunk
