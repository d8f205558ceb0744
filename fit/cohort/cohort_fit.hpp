#pragma once

#include "cohort/folder.hpp"
#include "cohort/table.hpp"
#include "subject/fit_request.hpp"

namespace trunk {

/// What a cohort is fitted with.
struct CohortPlan {
  /// Returns what a subject's row asks for; called from several threads. Throws InputError.
  std::function<FitRequest(const CohortSubject&)> request;
  std::string typed;   // the options given to all subjects that a result depends on
  std::string argv;    // the command line as typed
  bool force = false;  // fit again what is done
};

/// The outcome for one subject of a cohort.
struct SubjectResult {
  std::string subject;
  bool done = false;       // false: the user interrupted before
  bool found = false;      // an earlier command fitted it
  bool bad_input = false;  // it failed because of what the user gave
  std::filesystem::path file;
  std::optional<StoredFit> fit;  // none: it failed
  std::string error;             // why it failed
};

/// Fits every subject of a list, side by side, into a folder. A subject that fails is a result that says why,
/// and stops no other. A subject whose fit is in the folder, made from the same files and options, is not
/// fitted again. `execution.progress` is called with the number of subjects done. Returns one result per
/// subject, in the order of the list.
std::vector<SubjectResult> fit_subjects(const CohortList& list, const CohortPlan& plan,
                                        const CohortFolder& folder, const Execution& execution);

CohortRow row_of(const SubjectResult& result);

/// Returns what the JSON of a cohort holds of a subject; the details are in the subject's own files.
Json json_of(const SubjectResult& result);

}  // namespace trunk
