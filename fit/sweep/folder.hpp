#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "results/summary.hpp"
#include "sweep/design.hpp"

namespace trunk {

/// The folder of a sweep: fingerprint, one file a finished run, the table at the end.
///
///     DIR/fingerprint        what the folder belongs to
///     DIR/runs/00017.h5      one run, whole or not there
///     DIR/sweep.h5           the table and all curves, with links to the runs
///     DIR/table.csv          the table
class SweepFolder {
 public:
  /// Opens or creates. Throws InputError where the folder belongs to another sweep (design, scenarios or
  /// program version differ) and not `force`, or cannot be made or written to. With `force` such runs are
  /// deleted.
  SweepFolder(std::filesystem::path path, const SweepDesign& design, bool force);

  std::filesystem::path run_file(std::size_t run) const;
  std::string run_file_name(std::size_t run) const;  // relative to the folder
  bool is_done(std::size_t run) const;
  std::filesystem::path table_file() const { return path_ / "table.csv"; }
  std::filesystem::path sweep_file() const { return path_ / "sweep.h5"; }

 private:
  std::filesystem::path path_;
};

/// How far a folder is: counts finished runs among those its design asks for. Throws InputError where the
/// folder holds no sweep.
struct SweepProgress {
  std::size_t runs = 0, done = 0;
  bool has_table = false;
};
SweepProgress progress_of(const std::filesystem::path& folder);

}  // namespace trunk
