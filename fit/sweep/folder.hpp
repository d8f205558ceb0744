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

/// A part of the runs, for one of several processes: every count-th run.
struct Shard {
  std::size_t number = 1, count = 1;  // number from 1 to count
  bool has(std::size_t run) const noexcept { return run % count == number - 1; }
};

/// The folder of a sweep.
///
///     DIR/sweep.toml         the design as it was given
///     DIR/fingerprint        what the folder belongs to, and the hashes of the files it was made from
///     DIR/lock               held by whoever works here: by shards together, by others alone
///     DIR/journal/2-of-4     the rows of a shard, as its runs end
///     DIR/runs/00017.h5      one run with its trajectory (store = "full"), whole or not there
///     DIR/sweep.h5           the table and all curves, with links to the runs
///     DIR/table.csv          the table
class SweepFolder {
 public:
  /// Opens or creates, and locks. Throws InputError where the folder belongs to another sweep (design,
  /// scenarios, subjects or program version differ) and not `force`, is in use, or cannot be made or written
  /// to. With `force` what is there is deleted.
  SweepFolder(std::filesystem::path path, const SweepDesign& design, const Shard& shard, bool force);

  /// Opens what is there and locks it. Throws InputError where it holds no sweep of this program's version,
  /// or is in use.
  explicit SweepFolder(std::filesystem::path path);

  const std::filesystem::path& path() const noexcept { return path_; }
  std::filesystem::path run_file(std::size_t run) const;
  static std::string run_file_name(std::size_t run);  // relative to the folder
  std::filesystem::path table_file() const { return path_ / "table.csv"; }
  std::filesystem::path sweep_file() const { return path_ / "sweep.h5"; }

  Journal journal(const Shard& shard) const;
  /// The rows of all shards: the last one visited of a run is the one that counts (see read_journals).
  void for_each_row(const std::function<void(SweepRow)>& visit) const;

  /// The design and the hashes of its files, as they were when the sweep began.
  SweepDesign design() const;
  std::vector<std::pair<std::string, std::string>> inputs() const;  // file, SHA-256

 private:
  void lock(LockKind kind);

  std::filesystem::path path_;
  std::string fingerprint_;
  std::shared_ptr<const int> lock_;
};

}  // namespace trunk
