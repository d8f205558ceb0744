#include "cohort/cohort_fit.hpp"

#include <algorithm>
#include <numeric>
#include <thread>

#include "cohort/row.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "files/sha256.hpp"
#include "parallel/workers.hpp"
#include "records/provenance.hpp"
#include "subject/fit_job.hpp"
#include "subject/fit_json.hpp"

namespace trunk {
namespace {

/// One subject's fit, from its row to its files.
class CohortFit {
 public:
  CohortFit(const CohortList& list, const CohortPlan& plan, const CohortFolder& folder)
      : list_(list), plan_(plan), folder_(folder) {}

  /// Throws nothing: what goes wrong with a subject is its result.
  SubjectResult operator()(const CohortSubject& subject, const Execution& execution) const {
    SubjectResult result;
    result.subject = subject.name;
    result.file = folder_.fit_file(subject.name);
    result.done = true;
    try {
      result.fit = fitted(subject, execution, result.found);
    } catch (const Cancelled&) {
      result.done = false;
    } catch (const InputError& error) {
      result.bad_input = true;
      result.error = error.what();
    } catch (const std::exception& error) {
      result.error = error.what();
    }
    return result;
  }

 private:
  StoredFit fitted(const CohortSubject& subject, const Execution& execution, bool& found) const {
    FitRequest request = plan_.request(subject);
    request.output = folder_.fit_file(subject.name).string();
    FitJob job(request, execution, {[](const std::string&) {}, [](const std::string&) {}});
    const std::string fingerprint = fingerprint_of(job, subject);
    if (auto known = found_before(subject, fingerprint)) {
      found = true;
      return *known;
    }
    require_apart(job.inputs(), {request.output, folder_.summary_file(subject.name)});
    require_writable_output(request.output, true);
    const FitOutcome outcome = job.carry_out();
    StoredFit fit{summary_of(job.fit(), outcome), outcome.notes, fingerprint};
    folder_.store(subject.name, fit, fit_json(job.fit(), outcome));
    job.store(outcome, plan_.argv);
    return fit;
  }

  /// Of all that decides the result: program, scenario, options, row, files.
  std::string fingerprint_of(const FitJob& job, const CohortSubject& subject) const {
    std::string text = job.fit().problem_text() + plan_.typed;
    for (std::size_t i = 0; i < list_.columns.size(); ++i)
      if (!subject.cells[i].empty()) text += "\n" + list_.columns[i] + "=" + subject.cells[i];
    for (const auto& [file, hash] : provenance_of(job.inputs(), "").input_sha256) text += "\n" + hash;
    return sha256_of_text(text);
  }

  std::optional<StoredFit> found_before(const CohortSubject& subject, const std::string& fingerprint) const {
    const std::filesystem::path file = folder_.fit_file(subject.name);
    if (plan_.force || !std::filesystem::exists(file)) return std::nullopt;
    auto known = folder_.stored(subject.name);
    if (known && known->fingerprint == fingerprint) return known;
    throw InputError({file.string()}, "is another fit: its row, files, options or the program differ", "",
                     "delete it, or give --force, which fits every subject again");
  }

  const CohortList& list_;
  const CohortPlan& plan_;
  const CohortFolder& folder_;
};

}  // namespace

std::vector<SubjectResult> fit_subjects(const CohortList& list, const CohortPlan& plan,
                                        const CohortFolder& folder, const Execution& execution) {
  const CohortFit fit(list, plan, folder);
  const std::size_t subjects = list.subjects.size();
  const unsigned threads =
      execution.threads > 0 ? execution.threads : std::max(1u, std::thread::hardware_concurrency());
  const Execution inside{std::max(1u, threads / static_cast<unsigned>(subjects)), execution.cancelled, {}};
  std::vector<std::size_t> numbers(subjects);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::vector<SubjectResult> all(subjects);
  std::size_t done = 0;
  using Numbered = std::pair<std::size_t, SubjectResult>;
  work_off<Numbered>(
      numbers, threads, execution.cancelled,
      [&](std::size_t number) {
        return Numbered{number, fit(list.subjects[number], inside)};
      },
      [&](Numbered one) {
        if (one.second.done && execution.progress) execution.progress(++done);
        all[one.first] = std::move(one.second);
      });
  return all;
}

CohortRow row_of(const SubjectResult& result) {
  return result.fit ? cohort_row(result.subject, result.fit->summary)
                    : failed_row(result.subject, result.error);
}

Json json_of(const SubjectResult& result) {
  if (!result.fit) return {{"subject", result.subject}, {"status", "failed"}, {"error", result.error}};
  Json json{{"subject", result.subject}, {"file", result.file.string()}, {"found", result.found}};
  json.update(to_json(result.fit->summary));
  json["notes"] = result.fit->notes;
  return json;
}

}  // namespace trunk
