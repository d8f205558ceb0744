#pragma once

#include <mutex>

#include "cohort/list.hpp"
#include "cohort/table.hpp"
#include "commands/options/fit_options.hpp"
#include "commands/text/output.hpp"

namespace trunk {

/// Turns rows of a cohort's list into requests: a row is a command line, its columns the options. What it
/// leaves empty is as given to all. Files are relative to the list.
class CohortRows {
 public:
  /// Reads every row once. Throws InputError with the list's line: an unknown column, a value that the option
  /// does not take.
  CohortRows(const CohortList& list, const FitRequest& for_all);

  /// May be called from several threads.
  FitRequest request(const CohortSubject& subject);

 private:
  void require_columns();
  std::vector<std::string> arguments(const CohortSubject& subject);

  const CohortList& list_;
  FitRequest for_all_, request_;
  CLI::App options_;
  std::mutex mutex_;
};

/// The row of a subject from what `fit --json` said of it.
CohortRow cohort_row(const std::string& subject, const Json& fit);

/// One line a subject.
std::string cohort_table(const std::vector<CohortRow>& rows);

}  // namespace trunk
