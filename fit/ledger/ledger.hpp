#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trunk {

/// The result of one simulation, as far as a fit needs it.
struct LedgerEntry {
  std::int32_t status = 0;     ///< Ending::Status
  double lasted_s = 0.0;       ///< simulated time that was reached
  double wall_s = 0.0;         ///< time that the computation took
  std::vector<double> values;  ///< m3, the model at the measured samples; empty if the simulation failed
};

/// Holds every simulation of a fit; the key of an entry is the bytes of its parameters. Entries are in
/// memory, and also on disk if a file is named. An entry on disk outlives the process from the moment it is
/// added. So an interrupted fit resumes from its ledger and gives the same answer, bit for bit.
class Ledger {
 public:
  /// Keeps the entries in memory only.
  Ledger();
  /// Keeps the entries in a file too. `problem` is a text that holds everything an entry depends on. Entries
  /// of the same problem are read from the file; entries of another problem are deleted. Throws InputError if
  /// the file is not a ledger, is in use, or cannot be written.
  Ledger(const std::filesystem::path& path, const std::string& problem);
  ~Ledger();
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;

  /// Returns the entry, or nullptr if there is none.
  const LedgerEntry* find(const std::string& key) const;
  void add(const std::string& key, LedgerEntry entry);
  /// Returns the number of entries that the file held when it was opened.
  std::size_t found() const noexcept { return found_; }
  /// Deletes the file, because its fit is finished and its result is stored.
  void discard();

 private:
  void open(const std::string& problem);

  struct File;
  std::unique_ptr<File> file_;
  std::map<std::string, LedgerEntry> entries_;
  std::size_t found_ = 0;
};

}  // namespace trunk
