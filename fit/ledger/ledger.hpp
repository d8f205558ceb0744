#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trunk {

/// What came of one simulation, as far as a fit can see.
struct LedgerEntry {
  std::int32_t status = 0;     // Ending::Status
  double lasted_s = 0.0;       // how far the simulation came
  double wall_s = 0.0;         // time it took
  std::vector<double> values;  // m3, the model at the measured samples; empty where it failed
};

/// Every simulation of a fit, by the bytes of what was simulated. Kept in memory, and on disk where a file is
/// named: an entry survives the end of the process as soon as it is added, so that the same fit, asked for
/// again, finds what was done and goes on from there to the same answer.
class Ledger {
 public:
  /// In memory alone.
  Ledger();
  /// On file. What is there for the same `problem` (a text that says all that an entry depends on) is taken
  /// over; entries of another problem are dropped. Throws InputError where the file is not a ledger, is in
  /// use or cannot be written.
  Ledger(const std::filesystem::path& path, const std::string& problem);
  ~Ledger();
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;

  const LedgerEntry* find(const std::string& key) const;
  void add(const std::string& key, LedgerEntry entry);
  /// Entries that were on file when it was opened.
  std::size_t found() const noexcept { return found_; }
  /// Deletes the file: its fit is done and stored elsewhere.
  void discard();

 private:
  void open(const std::string& problem);

  struct File;
  std::unique_ptr<File> file_;
  std::map<std::string, LedgerEntry> entries_;
  std::size_t found_ = 0;
};

}  // namespace trunk
