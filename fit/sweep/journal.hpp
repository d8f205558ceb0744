#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trunk {

/// The row of a run that has ended.
struct SweepRow {
  std::uint64_t run = 0;
  std::string status, error;        // "completed", or how the run ended and why
  double ended_at = 0.0;            // s since 1970, by the clock of the machine that ran it
  bool has_file = false;            // true if its record is in runs/
  std::vector<double> measures;     // as in measures_of(); empty if the run never began
  std::vector<double> curve;        // dV in ml every curve_step_s; empty if it is not stored
  std::vector<double> intervals{};  // as in intervals_of(); empty if the subject has no draws
};

/// A file of rows, in the order in which runs end. An appended row outlives the process, whenever that ends.
/// Readers skip a row that is incomplete or damaged. A run may have several rows in several journals: see
/// read_journals.
class Journal {
 public:
  /// Opens the file to append. Anything after the last complete row is removed: rows of another sweep (see
  /// `fingerprint`), and the remains of a crash. Throws InputError if another process writes the file, or if
  /// it cannot be written.
  Journal(std::filesystem::path path, const std::string& fingerprint);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Appends the rows in one piece. Throws InputError if they cannot be written.
  void append(std::span<const SweepRow> rows);
  /// Waits until appended rows are on disk, so that they outlive a power cut.
  void synchronise();

 private:
  void write_all(std::string_view bytes);

  std::filesystem::path path_;
  int descriptor_;
};

/// Visits every complete row of a journal, also while it grows, and returns the end of the last one in bytes.
/// A journal of another sweep, or one that does not exist, has no rows. Throws InputError if the file cannot
/// be read.
std::size_t read_journal(const std::filesystem::path& path, const std::string& fingerprint,
                         const std::function<void(SweepRow)>& visit);

/// Visits rows of all journals in a folder, for runs below `runs`. A run may be visited several times; the
/// last visit counts. Precedence: completed over failed, then later `ended_at`, then later file name. So it
/// does not matter which shard tried a run first. Throws InputError if a file cannot be read.
void read_journals(const std::filesystem::path& folder, const std::string& fingerprint, std::size_t runs,
                   const std::function<void(SweepRow)>& visit);

}  // namespace trunk
