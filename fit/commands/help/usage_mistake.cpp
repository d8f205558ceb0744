#include "commands/help/usage_mistake.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "text/edit_distance.hpp"

namespace trunk {
namespace {

/// "-o" and "--output=FILE" are options, "-1" and "-.5" are numbers.
bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word[1] != '.' &&
         std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string see_help(const std::string& command) {
  return "see `" + command + " --help`";
}

Mistake unknown_option(const std::string& typed, const CLI::App& command, const std::string& called) {
  const std::string word = typed.substr(0, typed.find('='));
  const std::string near = nearest_name(word, option_names(command));
  const std::string found = fmt::format("unknown option '{}' of `{}`", word, called);
  return {{}, found, "", near.empty() ? see_help(called) : "did you mean '" + near + "'?", {}};
}

/// Returns two given options of the command that exclude each other, or two nulls.
std::pair<const CLI::Option*, const CLI::Option*> excluded_pair(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const CLI::Option* other : option->get_excludes())
      if (option->count() > 0 && other->count() > 0) return {option, other};
  return {nullptr, nullptr};
}

/// Returns the first given option whose value should be a number and is none, or null.
const CLI::Option* without_number(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string type = option->get_type_name();
    double number = 0.0;
    if ((type == "FLOAT" || type == "INT" || type == "UINT") && option->count() > 0 &&
        !CLI::detail::lexical_cast(option->results().back(), number))
      return option;
  }
  return nullptr;
}

/// Returns CLI11's words, or ours where they are plainer.
Mistake other_mistake(const CLI::App& command, const CLI::ParseError& error, const std::string& called) {
  if (const auto [one, other] = excluded_pair(command); one != nullptr)
    return {{},
            fmt::format("{} and {} cannot be used together", one->get_name(), other->get_name()),
            "",
            see_help(called),
            {}};
  if (const CLI::Option* option = without_number(command))
    return {{option->get_name()},
            fmt::format("'{}' found", option->results().back()),
            "a number",
            see_help(called),
            {}};
  return {{}, error.what(), "", see_help(called), {}};
}

/// A word before any command that the program itself does not know; `command` is the one that follows, if
/// any.
Mistake unknown_before_command(const std::string& word, const CLI::App& program, const CLI::App* command) {
  if (!looks_like_option(word)) return unknown_word("command", word, command_names(program));
  if (command != nullptr && command->get_option_no_throw(word) != nullptr)
    return {{},
            fmt::format("option '{}' stands before the command", word),
            "",
            fmt::format("write it after the command, as in `trunk {} {}`", command->get_name(), word),
            {}};
  return unknown_option(word, program, "trunk");
}

}  // namespace

Mistake unknown_word(const std::string& kind, const std::string& word,
                     const std::vector<std::string>& names) {
  const std::string near = nearest_name(word, names);
  const std::string found = fmt::format("unknown {} '{}'", kind, word);
  if (!near.empty()) return {{}, found, "", "did you mean '" + near + "'?", {}};
  return {{}, found, fmt::format("one of {}", fmt::join(names, ", ")), see_help("trunk"), {}};
}

Mistake usage_mistake(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App* command = chosen.empty() ? nullptr : chosen.front();
  if (const auto before = program.remaining(); !before.empty())
    return unknown_before_command(before.front(), program, command);
  if (command == nullptr)
    return {{},
            "no command is given",
            fmt::format("one of {}", fmt::join(command_names(program), ", ")),
            see_help("trunk"),
            {}};
  const std::string called = "trunk " + command->get_name();
  const std::vector<std::string> unknown = command->remaining();
  const auto option = std::find_if(unknown.begin(), unknown.end(), &looks_like_option);
  if (option != unknown.end()) return unknown_option(*option, *command, called);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !unknown.empty())
    return {{}, fmt::format("argument '{}' is not expected", unknown.front()), "", see_help(called), {}};
  return other_mistake(*command, error, called);
}

}  // namespace trunk
