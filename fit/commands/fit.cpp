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

Exit exit_of(Grade grade) {
  if (grade == Grade::not_converged) return Exit::not_converged;
  return grade == Grade::not_determined ? Exit::not_identifiable : Exit::done;
}

Execution watched(unsigned threads) {
  const auto report = [](std::size_t evaluations) {
    print_progress(fmt::format("fitting: {} simulations", evaluations));
  };
  return {threads, [] { return interrupted(); }, report};
}

Exit fit_command(const Common& common, FitRequest request, bool detailed) {
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
               fit_table(job.fit(), outcome, detailed) + "\nWritten to " + request.output);
  return exit_of(outcome.results.grade);
}

}  // namespace

void add_fit(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "fit", "Fits k_elasticity and k_muscle to a lung-volume trace, and says what the trace determines.");
  const auto r = std::make_shared<FitRequest>();
  const auto detailed = std::make_shared<bool>(false);
  add_scenario_option(*command, *r);
  command
      ->add_option("-o,--output", r->output,
                   "Writes the result to this file (HDF5). With --cohort, it is a folder.")
      ->type_name("FILE")
      ->required();
  command
      ->add_option(
          "--cohort", r->cohort,
          "Fits many subjects: a table (CSV) with the columns subject and trace. A column scenario, or the "
          "long name of an option of one subject, gives what differs between subjects.")
      ->type_name("FILE");
  add_subject_options(*command, *r);
  command
      ->add_option("--save-scenario", r->save_scenario,
                   "Writes the scenario with the fitted values to this file.")
      ->type_name("FILE");
  command
      ->add_option("-j,--threads", r->plan.estimation.execution.threads,
                   "Uses this many threads. [one per core]")
      ->type_name("N")
      ->check(whole_number(1, 1024));
  command->add_flag("--details", *detailed,
                    "Shows parameters, activation, joint region and search below the results as well.");
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces result files that exist.");
  command->footer(
      "Examples:\n"
      "  trunk fit recording.csv -o fit.h5\n"
      "  trunk fit recording.csv --flow \"Resp flow\" --unit L/min -o fit.h5\n"
      "  trunk fit scenarios/healthy.toml --trace recording.csv --starts 8 -o fit.h5\n"
      "  trunk fit --cohort subjects.csv -o cohort");
  command->callback([&common, &run, r, detailed, command] {
    const std::string typed = subject_options_text(*command);
    run = [&common, r, detailed, typed] {
      return r->cohort.empty() ? fit_command(common, *r, *detailed) : fit_cohort(common, *r, typed);
    };
  });
}

}  // namespace trunk
