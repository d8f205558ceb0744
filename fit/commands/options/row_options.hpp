#pragma once

#include <CLI/CLI.hpp>
#include <mutex>

#include "cohort/list.hpp"
#include "subject/fit_request.hpp"

namespace trunk {

/// Turns rows of a cohort's list into requests: a row is a command line, its columns are the options. An
/// empty cell leaves the option as it was given to all subjects. Files are relative to the list.
class RowOptions {
 public:
  /// Reads every row once. Throws InputError with the list's line if a column is unknown, or if an option
  /// does not take a value. `list` must outlive this object.
  RowOptions(const CohortList& list, const FitRequest& for_all);

  /// Returns what a row asks for. May be called from several threads.
  FitRequest request(const CohortSubject& subject);

 private:
  void require_columns();
  std::vector<std::string> arguments(const CohortSubject& subject);

  const CohortList& list_;
  FitRequest for_all_, request_;
  CLI::App options_;
  std::mutex mutex_;
};

}  // namespace trunk
