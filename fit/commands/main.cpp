#include <fmt/format.h>

#include "commands/commands.hpp"
#include "errors/input_error.hpp"
#include "recording/provenance.hpp"

namespace {

std::string joined(int argc, char** argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) text += (i > 0 ? " " : "") + std::string(argv[i]);
  return text;
}

/// CLI11's own messages can span lines; the program promises one.
int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  fmt::print(stderr, "trunk: {}; see `trunk --help`\n", error.what());
  return static_cast<int>(trunk::Exit::bad_input);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Fits a discrete model of the human trunk to lung volume traces, simulates it, sweeps scenarios."};
  app.name("trunk");
  app.require_subcommand(1);
  app.set_version_flag("--version", trunk::version_text());
  app.footer(
      "Exit codes: 0 done, 2 bad input, 3 diverged or not converged, 4 a free parameter is not "
      "identifiable.");
  trunk::Common common{joined(argc, argv), false, false};
  trunk::Run run;
  trunk::add_check(app, common, run);
  trunk::add_simulate(app, common, run);
  trunk::add_breaths(app, common, run);
  trunk::add_fit(app, common, run);
  trunk::add_sweep(app, common, run);
  trunk::add_status(app, common, run);
  trunk::add_inspect(app, common, run);
  try {
    app.parse(argc, argv);
    return static_cast<int>(run());
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
