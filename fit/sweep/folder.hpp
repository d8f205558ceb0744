#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "files/lock.hpp"
#include "sweep/design.hpp"
#include "sweep/journal.hpp"

namespace trunk {

/// The runs of one of several processes: every count-th run.
struct Shard {
  std::size_t number = 1, count = 1;  // number from 1 to count
  bool has(std::size_t run) const noexcept { return run % count == number - 1; }
};

/// The folder of a sweep.
///
///     DIR/sweep.toml         the design as it was given
///     DIR/fingerprint        the identity of the sweep, and the hashes of its input files (fingerprint.hpp)
///     DIR/lock               locked by the process that works here; shards share the lock
///     DIR/journal/2-of-4     the rows of a shard, in the order in which runs end
///     DIR/runs/00017.h5      one run with its trajectory (store = "full"); it is complete or does not exist
///     DIR/sweep.h5           the table and all curves, with links to the runs
///     DIR/table.csv          the table
class SweepFolder {
 public:
  /// Opens or creates the folder and locks it. With `force`, the content of another sweep is deleted. Throws
  /// InputError if the folder belongs to another sweep (design, scenarios, subjects or program version
  /// differ) and `force` is false, if it is in use, or if it cannot be made or written to.
  SweepFolder(const std::filesystem::path& path, const SweepDesign& design, const Shard& shard, bool force);

  /// Opens a folder and locks it. Throws InputError if it holds no sweep of this program's version, or if it
  /// is in use.
  explicit SweepFolder(const std::filesystem::path& path);

  const std::filesystem::path& path() const noexcept { return path_; }
  std::filesystem::path run_file(std::size_t run) const;
  static std::string run_file_name(std::size_t run);  // relative to the folder
  std::filesystem::path table_file() const { return path_ / "table.csv"; }
  std::filesystem::path sweep_file() const { return path_ / "sweep.h5"; }

  Journal journal(const Shard& shard) const;
  /// Visits the rows of all shards. If a run has several rows, the last one visited counts (see
  /// read_journals).
  void for_each_row(const std::function<void(SweepRow)>& visit) const;

  /// Return the design, and the hashes of its files, as they were when the sweep began. design() throws
  /// InputError if the file was changed.
  SweepDesign design() const;
  std::vector<std::pair<std::string, std::string>> inputs() const;  // file, SHA-256

 private:
  void lock(LockKind kind);

  std::filesystem::path path_;
  std::string fingerprint_;
  std::shared_ptr<const int> lock_;
};

}  // namespace trunk
