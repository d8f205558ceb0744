#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cohort/list.hpp"

namespace trunk {

/// The folder of a cohort.
///
///     DIR/cohort.list      the list, as it was last given
///     DIR/cohort.csv       the table
///     DIR/S01.h5           the fit of subject S01
///     DIR/S01.json         what `fit --json` says of it, with the fingerprint of what it was made from
class CohortFolder {
 public:
  /// Opens or creates. Throws InputError where the folder holds something else and not `force`, or cannot be
  /// made or written to.
  CohortFolder(std::filesystem::path path, const CohortList& list, bool force);

  std::filesystem::path fit_file(const std::string& subject) const;
  std::filesystem::path summary_file(const std::string& subject) const;
  std::filesystem::path table_file() const { return path_ / "cohort.csv"; }

  /// The summary of a subject whose fit is finished; none where there is none.
  std::optional<std::string> summary(const std::string& subject) const;
  void store_summary(const std::string& subject, const std::string& text) const;
  void store_table(const std::string& text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace trunk
