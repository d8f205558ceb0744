#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <csignal>
#include <cstdio>

#include "commands/commands.hpp"
#include "commands/program.hpp"
#include "errors/input_error.hpp"
#include "records/provenance.hpp"

namespace {

std::string joined(int argc, char** argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) text += (i > 0 ? " " : "") + std::string(argv[i]);
  return text;
}

/// CLI11's own messages can span lines; the program promises one.
int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  std::string text = error.what();
  if (app.get_subcommands().empty() && !app.remaining().empty()) {
    text = "unknown command '" + app.remaining().front() + "', expected one of";
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
      text += " " + command->get_name();
  }
  fmt::print(stderr, "trunk: {}; see `trunk --help`\n", text);
  return static_cast<int>(trunk::Exit::bad_input);
}

}  // namespace

std::string trunk::require_within(const std::string& text, double lowest, double highest) {
  double number = 0.0;
  const bool good =
      CLI::detail::lexical_cast(text, number) && number >= lowest && number <= highest;  // NaN is neither
  return good ? "" : fmt::format("'{}', expected a number from {:g} to {:g}", text, lowest, highest);
}

int trunk::run_program(int argc, char** argv) {
  gsl_set_error_handler_off();    // it would abort
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is then an error of write() like a full disk
  CLI::App app{
      "Fits a discrete model of the human trunk to lung volume traces, simulates it, sweeps scenarios."};
  app.name("trunk");
  app.require_subcommand(1);
  app.set_version_flag("--version", trunk::version_text());
  app.footer(
      "Exit codes: 0 done, 1 different (diff, replay), 2 bad input, 3 diverged or not converged, 4 a free "
      "parameter is not "
      "identifiable, 130 interrupted.");
  trunk::Common common{joined(argc, argv), false, false};
  trunk::Run run;
  trunk::add_check(app, common, run);
  trunk::add_simulate(app, common, run);
  trunk::add_breaths(app, common, run);
  trunk::add_fit(app, common, run);
  trunk::add_sweep(app, common, run);
  trunk::add_status(app, common, run);
  trunk::add_merge(app, common, run);
  trunk::add_validate(app, common, run);
  trunk::add_inspect(app, common, run);
  trunk::add_diff(app, common, run);
  trunk::add_replay(app, common, run);
  trunk::add_export(app, common, run);
  trunk::add_register(app, common, run);
  trunk::add_compare(app, common, run);
  trunk::add_report(app, common, run);
  try {
    app.parse(argc, argv);
    const trunk::Exit exit = run();
    if (std::fflush(stdout) != 0)
      throw trunk::InputError("standard output cannot be written; is the disk full?");
    return static_cast<int>(exit);
  } catch (const CLI::ParseError& error) {
    return report_usage(app, error);
  } catch (const trunk::InputError& error) {
    trunk::clear_progress();
    fmt::print(stderr, "trunk: {}\n", error.what());
    return static_cast<int>(trunk::Exit::bad_input);
  } catch (const std::exception& error) {
    trunk::clear_progress();
    fmt::print(stderr, "trunk: {}\n", error.what());
    return static_cast<int>(trunk::Exit::not_converged);
  }
}
