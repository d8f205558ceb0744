#include "commands/program.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <charconv>
#include <csignal>

#include "commands/commands.hpp"
#include "commands/help/help_text.hpp"
#include "commands/help/topics.hpp"
#include "commands/help/usage_mistake.hpp"
#include "records/provenance.hpp"
#include "text/edit_distance.hpp"

namespace trunk {
namespace {

std::string joined(int argc, char** argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) text += (i > 0 ? " " : "") + std::string(argv[i]);
  return text;
}

/// The heading under which the program's help lists some commands, and what adds them.
struct CommandGroup {
  const char* heading;
  std::vector<void (*)(CLI::App&, Common&, Run&)> add;
};

/// `help` comes last: it describes the commands that are there when it is added.
const std::vector<CommandGroup>& command_groups() {
  static const std::vector<CommandGroup> groups{
      {"Look before you fit", {&add_check, &add_breaths}},
      {"Fit and simulate", {&add_fit, &add_simulate, &add_register}},
      {"Many simulations", {&add_sweep, &add_status, &add_merge}},
      {"Look at results", {&add_inspect, &add_report, &add_compare, &add_export}},
      {"Check results", {&add_diff, &add_replay, &add_validate}},
      {"Help", {&add_help}}};
  return groups;
}

std::string program_notes() {
  std::string text = "Topics, for `trunk help TOPIC`:\n";
  for (const Topic& topic : topics()) text += fmt::format("  {:<26}  {}\n", topic.name, topic.summary);
  return text +
         "\n"
         "Exit codes:\n"
         "  0    The command did its work.\n"
         "  1    `diff` or `replay` found a difference.\n"
         "  2    The input or the command line cannot be used.\n"
         "  3    A simulation diverged, a fit did not converge, or a bound does not hold.\n"
         "  4    The fit converged, but a result that it shows first is not determined.\n"
         "  130  You interrupted the command.";
}

void add_commands(CLI::App& app, Common& common, Run& run) {
  app.name("trunk");
  app.description(
      "Fits a mechanical model of the human trunk to lung-volume traces. It also simulates the model, alone "
      "or "
      "over many parameters.");
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "Prints this help.");
  app.set_version_flag("--version", version_text(),
                       "Prints the version of the program, and of the libraries it uses.");
  app.footer(program_notes());
  for (const CommandGroup& group : command_groups())
    for (const auto add : group.add) {
      add(app, common, run);
      app.get_subcommands([](const CLI::App*) { return true; }).back()->group(group.heading);
    }
}

std::string help_of(const CLI::App& app) {
  const CommandTable table = command_table(app);
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? program_help(table) : command_help(*table.find(chosen.front()->get_name()));
}

/// Reads the command line and does what it asks for. Throws InputError, also for a wrong command line.
Exit carry_out(CLI::App& app, Run& run, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::CallForHelp&) {
    print_text(help_of(app));
  } catch (const CLI::CallForVersion& version) {
    print_text(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    throw InputError(usage_mistake(app, error));
  }
  return Exit::done;
}

}  // namespace

void add_json_flag(CLI::App& command, Common& common) {
  command.add_flag("--json", common.json, "Prints one JSON object instead of text.");
}

void add_force_flag(CLI::App& command, Common& common, const std::string& text) {
  command.add_flag("--force", common.force, text);
}

std::string require_within(const std::string& text, double lowest, double highest) {
  double number = 0.0;
  const bool good =
      CLI::detail::lexical_cast(text, number) && number >= lowest && number <= highest;  // NaN is neither
  return good ? "" : fmt::format("'{}' found; expected a number from {:g} to {:g}", text, lowest, highest);
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  return {[names, all](const std::string& text) -> std::string {
            if (std::find(names.begin(), names.end(), text) != names.end()) return "";
            const std::string near = nearest_name(text, names);
            return fmt::format("'{}' found; expected one of {}{}", text, all,
                               near.empty() ? "" : "; did you mean '" + near + "'?");
          },
          "{" + fmt::format("{}", fmt::join(names, ",")) + "}"};
}

CLI::Validator whole_number(std::int64_t lowest, std::int64_t highest) {
  return {[=](const std::string& text) -> std::string {
            std::int64_t number = 0;
            const char* end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, number);
            if (read.ec == std::errc() && read.ptr == end && number >= lowest && number <= highest) return "";
            return fmt::format("'{}' found; expected a whole number from {} to {}", text, lowest, highest);
          },
          ""};
}

int run_program(int argc, char** argv) {
  gsl_set_error_handler_off();    // it would abort
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is then an error of write() like a full disk
  Common common{joined(argc, argv), false, false};
  CLI::App app;
  Run run;
  Exit exit = Exit::done;
  try {
    add_commands(app, common, run);
    exit = carry_out(app, run, argc, argv);
    flush_text();
  } catch (const InputError& error) {
    print_error(error.what());
    exit = Exit::bad_input;
  } catch (const std::exception& error) {
    print_error(error.what());
    exit = Exit::not_converged;
  }
  return static_cast<int>(exit);
}

}  // namespace trunk
