#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trunk {

/// What the table needs of a run that has ended.
struct SweepRow {
  std::uint64_t run = 0;
  std::string status, error;     // "completed", or how it ended and why
  double ended_at = 0.0;         // s since 1970, by the clock of the machine that ran it
  bool has_file = false;         // the whole of it is in runs/
  std::vector<double> measures;  // as in measures_of(); empty where it never began
  std::vector<double> curve;     // dV in ml every curve_step_s; empty where it is not kept
};

/// Rows on file, in the order in which runs end. A row that is appended survives the end of the process at
/// any moment; one that was half written or is damaged is passed over by whoever reads. A run may have
/// several rows, in several journals: see read_journals.
class Journal {
 public:
  /// Opens to append, alone: throws InputError where another process is at it. What another sweep (see
  /// `fingerprint`) or a crash left behind the last whole row is removed.
  Journal(std::filesystem::path path, const std::string& fingerprint);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// In one piece. Throws InputError where it cannot be written.
  void append(std::span<const SweepRow> rows);
  /// Makes what was appended outlast a power cut.
  void synchronise();

 private:
  void write_all(std::string_view bytes);

  std::filesystem::path path_;
  int descriptor_;
};

/// Visits every whole row; the journal may be growing. One of another sweep, or none, has no rows. Returns
/// where the last whole row ends, bytes. Throws InputError where the file cannot be read.
std::size_t read_journal(const std::filesystem::path& path, const std::string& fingerprint,
                         const std::function<void(SweepRow)>& visit);

/// Visits the rows of all journals of a folder, of runs below `runs`, less those that do not count over a row
/// visited before: the last one visited of a run is the one that counts. That is one that completed; of
/// several such, or of none, the one that ended last; and of those that ended at once the one read last,
/// files in the order of their names. So it does not matter which shard tried a run first.
void read_journals(const std::filesystem::path& folder, const std::string& fingerprint, std::size_t runs,
                   const std::function<void(SweepRow)>& visit);

}  // namespace trunk
