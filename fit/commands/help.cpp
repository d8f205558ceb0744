#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands/commands.hpp"
#include "commands/help/completions.hpp"
#include "commands/help/help_text.hpp"
#include "commands/help/manual_page.hpp"
#include "commands/help/topics.hpp"
#include "commands/help/usage_mistake.hpp"
#include "records/provenance.hpp"

namespace trunk {
namespace {

struct HelpRequest {
  std::string subject, shell;
  bool manual = false;
};

/// Commands first, then topics.
std::vector<std::string> subjects(const CommandTable& table) {
  std::vector<std::string> names;
  for (const CommandRow& command : table.commands) names.push_back(command.name);
  for (const Topic& topic : topics()) names.emplace_back(topic.name);
  return names;
}

std::string subject_text(const CommandTable& table, const std::string& subject) {
  if (const CommandRow* command = table.find(subject)) return command_help(*command);
  for (const Topic& topic : topics())
    if (topic.name == subject) return std::string(topic.page);
  throw InputError(unknown_word("command or topic", subject, subjects(table)));
}

Exit help_command(const CLI::App& program, const HelpRequest& request) {
  const CommandTable table = command_table(program);
  std::string text;
  if (request.manual)
    text = manual_page(table, version_text().substr(0, version_text().find(" (")));
  else if (request.shell == "bash")
    text = bash_completion(table);
  else if (request.shell == "zsh")
    text = zsh_completion(table);
  else if (request.shell == "fish")
    text = fish_completion(table);
  else
    text = request.subject.empty() ? program_help(table) : subject_text(table, request.subject);
  print_text(text);
  return Exit::done;
}

}  // namespace

void add_help(CLI::App& app, Common&, Run& run) {
  auto* command = app.add_subcommand("help", "Prints the help of a command, or a page about a topic.");
  const auto request = std::make_shared<HelpRequest>();
  auto* subject = command->add_option("SUBJECT", request->subject,
                                      "The command or topic. Without it, `trunk help` lists all of them.");
  subject->type_name(fmt::format("SUBJECT:{{{}}}", fmt::join(subjects(command_table(app)), ",")));
  auto* manual = command->add_flag("--man", request->manual,
                                   "Prints the manual page, for `man -l`. It covers all commands.");
  auto* shell = command
                    ->add_option("--completion", request->shell,
                                 "Prints a script that makes this shell complete commands and options.")
                    ->type_name("SHELL")
                    ->check(one_of({"bash", "zsh", "fish"}));
  subject->excludes(manual)->excludes(shell);
  manual->excludes(shell);
  command->footer(
      "Examples:\n"
      "  trunk help fit\n"
      "  trunk help registration | less\n"
      "  trunk help --man > trunk.1\n"
      "  source <(trunk help --completion bash)");
  command->callback([&app, &run, request] { run = [&app, request] { return help_command(app, *request); }; });
}

}  // namespace trunk
