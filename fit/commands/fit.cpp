#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/fit_cohort.hpp"
#include "commands/options/fit_options.hpp"
#include "commands/text/fit_text.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "subject/fit_job.hpp"
#include "subject/fit_json.hpp"

namespace trunk {
namespace {

void require_results_free(const Common& common, const FitRequest& request, const FitJob& job) {
  std::vector<std::filesystem::path> outputs = {request.output};
  if (!request.save_scenario.empty()) outputs.emplace_back(request.save_scenario);
  require_apart(job.inputs(), outputs);
  for (const auto& output : outputs) require_writable_output(output, common.force);
}

Exit exit_of(const Estimation& e) {
  if (!e.search.converged) return Exit::not_converged;
  return status_of(e) == "converged" ? Exit::done : Exit::not_identifiable;
}

Execution watched(unsigned threads) {
  const auto report = [](std::size_t evaluations) {
    print_progress(fmt::format("fitting: {} simulations", evaluations));
  };
  return {threads, [] { return interrupted(); }, report};
}

Exit fit_command(const Common& common, FitRequest request) {
  const std::vector<std::string> notes = settle_files(request);
  FitJob job(request, watched(request.plan.estimation.execution.threads),
             {[](const std::string& text) { print_note("note: " + text); }, &print_progress});
  require_results_free(common, request, job);
  for (const std::string& note : notes) print_note("note: " + note);
  for (const std::string& note : job.notes()) print_note("note: " + note);
  catch_interrupts();
  FitOutcome outcome;
  try {
    outcome = job.carry_out();
  } catch (const Cancelled&) {
    print_note(fmt::format("interrupted: only {} was written; the same command goes on from it",
                           job.ledger_file().string()));
    return Exit::interrupted;
  }
  job.store(outcome, common.argv);
  print_result(common, fit_json(job.fit(), outcome),
               fit_table(job.fit(), outcome) + "\nWritten to " + request.output);
  return exit_of(outcome.estimation);
}

}  // namespace

void add_fit(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("fit", "Fit k_elasticity and k_muscle to a lung volume trace");
  const auto r = std::make_shared<FitRequest>();
  add_scenario_option(*command, *r);
  command->add_option("--cohort", r->cohort,
                      "fit many subjects: a table (CSV) with the columns subject and trace, and a column "
                      "scenario, or the long "
                      "name of an option below, for each that differs from subject to subject");
  command->add_option("-o,--output", r->output, "result file (HDF5); with --cohort, the output folder")
      ->required();
  add_subject_options(*command, *r);
  command->add_option("--save-scenario", r->save_scenario,
                      "write the scenario with the fitted values to this file");
  command
      ->add_option("-j,--threads", r->plan.estimation.execution.threads, "number of threads [one per core]")
      ->check(CLI::Range(1u, 1024u));
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace result files that exist");
  command->callback([&common, &run, r, command] {
    const std::string typed = subject_options_text(*command);
    run = [&common, r, typed] {
      return r->cohort.empty() ? fit_command(common, *r) : fit_cohort(common, *r, typed);
    };
  });
}

}  // namespace trunk
