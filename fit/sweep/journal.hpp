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
  double ended_at = 0.0;         // s since 1970: for the rate alone
  bool has_file = false;         // the whole of it is in runs/
  std::vector<double> measures;  // as in measures_of(); empty where it never began
  std::vector<double> curve;     // dV in ml every curve_step_s; empty where it is not kept
};

/// Rows on file, in the order in which runs end. A row that is appended survives the end of the process at
/// any moment; one that was half written is dropped by whoever reads. A run may have several rows: the last
/// one counts.
class Journal {
 public:
  /// Opens to append, alone: throws InputError where another process is at it. What another sweep (see
  /// `fingerprint`) or a crash left is removed.
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
/// where the whole rows end, bytes. Throws InputError where the file cannot be read.
std::size_t read_journal(const std::filesystem::path& path, const std::string& fingerprint,
                         const std::function<void(SweepRow)>& visit);

}  // namespace trunk
