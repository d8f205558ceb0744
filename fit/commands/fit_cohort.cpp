#include "commands/fit_cohort.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cohort/cohort_fit.hpp"
#include "commands/options/fit_options.hpp"
#include "commands/options/row_options.hpp"
#include "commands/text/cohort_text.hpp"
#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// The exit codes of all subjects in one.
Exit exit_of(const std::vector<SubjectResult>& all) {
  const auto any = [&](auto is) { return std::any_of(all.begin(), all.end(), is); };
  if (std::all_of(all.begin(), all.end(), [](const SubjectResult& r) { return r.bad_input; }))
    return Exit::bad_input;
  if (any([](const SubjectResult& r) { return !r.fit || r.fit->summary.status == "not_converged"; }))
    return Exit::not_converged;
  return any([](const SubjectResult& r) { return r.fit->summary.grade == Grade::not_determined; })
             ? Exit::not_identifiable
             : Exit::done;
}

void report(const Common& common, const CohortFolder& folder, const std::vector<SubjectResult>& all,
            double wall_s) {
  std::vector<CohortRow> rows;
  Json subjects = Json::array();
  for (const SubjectResult& r : all) {
    rows.push_back(row_of(r));
    subjects.push_back(json_of(r));
  }
  folder.store_table(cohort_csv(rows));
  const auto found = std::count_if(all.begin(), all.end(), [](const SubjectResult& r) { return r.found; });
  const auto failed = std::count_if(all.begin(), all.end(), [](const SubjectResult& r) { return !r.fit; });
  const std::string table = folder.table_file().string();
  print_result(
      common,
      {{"schema", "trunk.cohort/2"},
       {"subjects", subjects},
       {"found", found},
       {"failed", failed},
       {"table", table},
       {"wall_s", wall_s}},
      fmt::format("{}\n{} subjects: {} were done before, {} failed; {:.1f} s\nThe table is in {}, beside the "
                  "fit of each subject",
                  cohort_table(rows), all.size(), found, failed, wall_s, table));
}

}  // namespace

Exit fit_cohort(const Common& common, FitRequest request, const std::string& typed) {
  if (!request.save_scenario.empty())
    throw InputError({"--save-scenario " + request.save_scenario}, "this option names one file",
                     "one subject instead of --cohort");
  const std::vector<std::string> notes = settle_files(request);
  const CohortList list = read_cohort_list(request.cohort);
  RowOptions rows(list, request);
  const CohortFolder folder(request.output, list, common.force);
  for (const std::string& note : notes) print_note("note: " + note);
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const CohortPlan plan{[&](const CohortSubject& subject) { return rows.request(subject); }, typed,
                        common.argv, common.force};
  const auto progress = [&](std::size_t done) {
    print_progress(fmt::format("cohort: {} of {} done", done, list.subjects.size()));
  };
  const std::vector<SubjectResult> all =
      fit_subjects(list, plan, folder,
                   {request.plan.estimation.execution.threads, [] { return interrupted(); }, progress});
  const auto done = std::count_if(all.begin(), all.end(), [](const SubjectResult& r) { return r.done; });
  if (static_cast<std::size_t>(done) < all.size()) {
    print_note(fmt::format("interrupted: {} of {} subjects are done; the same command goes on from there",
                           done, all.size()));
    return Exit::interrupted;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  report(common, folder, all, wall.count());
  return exit_of(all);
}

std::string subject_options_text(const CLI::App& command) {
  static constexpr std::string_view others[] = {"output", "cohort", "threads", "details",
                                                "json",   "force",  "help"};
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
