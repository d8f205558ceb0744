#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cohort/list.hpp"
#include "cohort/stored_fit.hpp"

namespace trunk {

/// The folder of a cohort.
///
///     DIR/cohort.list      the list, as it was last given
///     DIR/cohort.csv       the table
///     DIR/S01.h5           the fit of subject S01
///     DIR/S01.json         what `fit --json` prints for it, with notes and the fingerprint (see StoredFit)
class CohortFolder {
 public:
  /// Opens or creates the folder and stores the list. Throws InputError if the folder holds something else
  /// (unless `force`), or cannot be made or written to.
  CohortFolder(std::filesystem::path path, const CohortList& list, bool force);

  std::filesystem::path fit_file(const std::string& subject) const;
  std::filesystem::path summary_file(const std::string& subject) const;
  std::filesystem::path table_file() const { return path_ / "cohort.csv"; }

  /// Returns what is known of a subject whose fit is complete; nothing if there is no such fit. Throws
  /// InputError if the summary is damaged.
  std::optional<StoredFit> stored(const std::string& subject) const;
  /// `details` is what `fit --json` prints. The summary counts only once the fit is there.
  void store(const std::string& subject, const StoredFit& fit, const Json& details) const;
  void store_table(const std::string& text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace trunk
