#include "commands/fit_cohort.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>

#include "cohort/folder.hpp"
#include "commands/cohort_rows.hpp"
#include "commands/text/fit_text.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "files/sha256.hpp"
#include "parallel/workers.hpp"
#include "records/provenance.hpp"

namespace trunk {
namespace {

/// What a worker hands back.
struct Fitted {
  std::size_t number = 0;
  CohortRow row;
  Json json;
  bool found = false, bad_input = false, cancelled = false;
};

/// One subject's fit, from its row to its files.
class CohortFit {
 public:
  CohortFit(const Common& common, const FitRequest& for_all, std::string typed)
      : common_(common),
        typed_(std::move(typed)),
        list_(read_cohort_list(for_all.cohort)),
        rows_(list_, for_all),
        folder_(for_all.output, list_, common.force) {}

  const CohortList& list() const { return list_; }
  const CohortFolder& folder() const { return folder_; }

  /// Never throws: what goes wrong with a subject is its row.
  Fitted operator()(std::size_t number, unsigned threads) {
    const CohortSubject& subject = list_.subjects[number];
    Fitted result{number, {}, {}};
    try {
      const Json fit = fitted(subject, threads, result.found);
      result.row = cohort_row(subject.name, fit);
      result.json = brief(fit, subject.name, result.found);
      return result;
    } catch (const Cancelled&) {
      result.cancelled = true;
    } catch (const InputError& error) {
      result.bad_input = true;
      result.row.error = error.what();
    } catch (const std::exception& error) {
      result.row.error = error.what();
    }
    result.row.subject = subject.name;
    result.row.status = "failed";
    result.json = {{"subject", subject.name}, {"status", "failed"}, {"error", result.row.error}};
    return result;
  }

 private:
  Json fitted(const CohortSubject& subject, unsigned threads, bool& found) {
    FitRequest request = rows_.request(subject);
    request.output = folder_.fit_file(subject.name).string();
    std::vector<std::string> notes;
    FitJob job(request, {threads, [] { return interrupted(); }, {}},
               {[&](const std::string& text) { notes.push_back(text); }, [](const std::string&) {}});
    const std::string fingerprint = fingerprint_of(job, subject);
    if (const auto known = found_before(subject, fingerprint)) {
      found = true;
      return *known;
    }
    require_apart(job.inputs(), {request.output, folder_.summary_file(subject.name)});
    require_writable_output(request.output, true);
    const FitOutcome outcome = job.carry_out();
    Json json = fit_json(job.fit(), outcome);
    notes.insert(notes.begin(), job.notes().begin(), job.notes().end());
    json["notes"] = notes;
    json["fingerprint"] = fingerprint;
    folder_.store_summary(subject.name, json.dump(2));  // counts only once the fit is there
    job.store(outcome, common_.argv);
    return json;
  }

  /// Of all that decides the result: program, scenario, options, row, files.
  std::string fingerprint_of(const FitJob& job, const CohortSubject& subject) const {
    std::string text = job.fit().problem_text() + typed_;
    for (std::size_t i = 0; i < list_.columns.size(); ++i)
      if (!subject.cells[i].empty()) text += "\n" + list_.columns[i] + "=" + subject.cells[i];
    for (const auto& [file, hash] : provenance_of(job.inputs(), "").input_sha256) text += "\n" + hash;
    return sha256_of_text(text);
  }

  std::optional<Json> found_before(const CohortSubject& subject, const std::string& fingerprint) const {
    const std::filesystem::path file = folder_.fit_file(subject.name);
    if (common_.force || !std::filesystem::exists(file)) return std::nullopt;
    const Json known = Json::parse(folder_.summary(subject.name).value_or(""), nullptr, false);
    if (known.is_object() && known.value("fingerprint", "") == fingerprint) return known;
    throw InputError(
        file.string(), 0,
        "is another fit (its row, files, options or the program differ); expected it deleted, or "
        "--force, which fits every subject again");
  }

  /// What the cohort's own JSON says of a subject; the rest is in its file.
  Json brief(const Json& fit, const std::string& subject, bool found) const {
    Json json{{"subject", subject}, {"file", folder_.fit_file(subject).string()}, {"found", found}};
    for (const char* key :
         {"status", "identifiable", "parameters", "ratio", "nrmse_percent", "baseline_nrmse_percent",
          "tidal_volume_measured_ml", "breaths_used", "breaths_rejected", "median_latency_ms", "predictions",
          "verdict", "simulated", "notes"})
      if (fit.contains(key)) json[key] = fit[key];
    return json;
  }

  const Common& common_;
  std::string typed_;
  CohortList list_;
  CohortRows rows_;
  CohortFolder folder_;
};

/// Everyone's exit code in one.
Exit exit_of(const std::vector<Fitted>& all) {
  const auto any = [&](auto is) { return std::any_of(all.begin(), all.end(), is); };
  if (std::all_of(all.begin(), all.end(), [](const Fitted& f) { return f.bad_input; }))
    return Exit::bad_input;
  if (any([](const Fitted& f) { return f.row.status == "failed" || f.row.status == "not_converged"; }))
    return Exit::not_converged;
  return any([](const Fitted& f) { return !f.row.identifiable; }) ? Exit::not_identifiable : Exit::done;
}

void report(const Common& common, const CohortFolder& folder, const std::vector<Fitted>& all, double wall_s) {
  std::vector<CohortRow> rows;
  Json subjects = Json::array();
  for (const Fitted& f : all) {
    rows.push_back(f.row);
    subjects.push_back(f.json);
  }
  folder.store_table(cohort_csv(rows));
  const auto count = [&](auto is) { return std::count_if(all.begin(), all.end(), is); };
  const auto found = count([](const Fitted& f) { return f.found; });
  const auto failed = count([](const Fitted& f) { return f.row.status == "failed"; });
  print_result(
      common,
      {{"schema", "trunk.cohort/1"},
       {"subjects", subjects},
       {"found", found},
       {"failed", failed},
       {"table", folder.table_file().string()},
       {"wall_s", wall_s}},
      fmt::format("{}\n{} subjects, {} found done, {} failed, {:.1f} s\nTable in {}, a fit a subject "
                  "beside it",
                  cohort_table(rows), all.size(), found, failed, wall_s, folder.table_file().string()));
}

}  // namespace

Exit fit_cohort(const Common& common, FitRequest request, const std::string& typed) {
  if (!request.save_scenario.empty())
    throw InputError("--save-scenario names one file, expected one subject instead of --cohort");
  const std::vector<std::string> notes = settle_files(request);
  CohortFit fit(common, request, typed);
  for (const std::string& note : notes) print_note("note: " + note);
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const std::size_t subjects = fit.list().subjects.size();
  unsigned threads = request.plan.estimation.execution.threads;
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  const auto inside = std::max(1u, threads / static_cast<unsigned>(subjects));
  std::vector<std::size_t> numbers(subjects);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::vector<Fitted> all(subjects);
  std::size_t done = 0;
  work_off<Fitted>(
      numbers, threads, [] { return interrupted(); }, [&](std::size_t number) { return fit(number, inside); },
      [&](Fitted fitted) {
        if (fitted.cancelled) return;
        print_progress(fmt::format("cohort: {} of {} done", ++done, subjects));
        all[fitted.number] = std::move(fitted);
      });
  if (done < subjects) {
    print_note(fmt::format("interrupted: {} of {} subjects are done; the same command goes on from there",
                           done, subjects));
    return Exit::interrupted;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  report(common, fit.folder(), all, wall.count());
  return exit_of(all);
}

std::string subject_options_text(const CLI::App& command) {
  static constexpr std::string_view others[] = {"output", "cohort", "threads", "json", "force", "help"};
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_lnames().empty() ? option->get_name() : option->get_lnames().front();
    if (option->count() == 0 || std::find(std::begin(others), std::end(others), name) != std::end(others))
      continue;
    text += "\n--" + name;
    for (const std::string& value : option->results()) text += " " + value;
  }
  return text;
}

}  // namespace trunk
