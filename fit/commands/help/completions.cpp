#include "commands/help/completions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace trunk {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  return fmt::format("{}", fmt::join(words, between));
}

std::vector<std::string> command_names(const CommandTable& table) {
  std::vector<std::string> names;
  for (const CommandRow& command : table.commands) names.push_back(command.name);
  return names;
}

/// In single quotes, as all three shells read it; fish also knows an escape in them, which no text holds.
std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  return out + "'";
}

/// What _arguments of zsh takes for the end of a description has a backslash before it.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : first_sentence(text)) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_spec(const OptionRow& row) {
  const std::string values = row.choices.empty() ? "_files" : "(" + joined(row.choices, " ") + ")";
  if (row.is_argument)
    return shell_quoted(fmt::format("{}:{}:{}",
                                    row.repeated   ? "*"
                                    : row.required ? ""
                                                   : ":",
                                    row.names.front(), values));
  std::string specs;
  for (const std::string& name : row.names) {
    const std::string text = "[" + zsh_text(row.text) + "]";
    const std::string equals = name.starts_with("--") ? "=" : "+";
    const std::string spec =
        row.value.empty() ? name + text : name + equals + text + ":" + row.value + ":" + values;
    specs += (specs.empty() ? "" : " ") + shell_quoted((row.repeated ? "*" : "") + spec);
  }
  return specs;
}

std::string bash_case(const CommandRow& command) {
  std::string out, arguments;
  std::vector<std::string> options, with_files;
  for (const OptionRow& row : command.options) {
    if (row.is_argument) {
      arguments = joined(row.choices, " ");
      continue;
    }
    options.insert(options.end(), row.names.begin(), row.names.end());
    if (!row.choices.empty())
      out += fmt::format("                {}) words={} ;;\n", joined(row.names, "|"),
                         shell_quoted(joined(row.choices, " ")));
    else if (!row.value.empty())
      with_files.insert(with_files.end(), row.names.begin(), row.names.end());
  }
  if (!with_files.empty()) out += fmt::format("                {}) ;;\n", joined(with_files, "|"));
  return fmt::format(
      "        {})\n            case $before in\n{}                *) if [[ $word == -* ]]; "
      "then words={}; else words={}; fi ;;\n            esac ;;\n",
      command.name, out, shell_quoted(joined(options, " ")), shell_quoted(arguments));
}

}  // namespace

std::string bash_completion(const CommandTable& table) {
  std::vector<std::string> first = command_names(table);
  for (const OptionRow& row : table.program.options)
    first.insert(first.end(), row.names.begin(), row.names.end());
  std::string out = fmt::format(
      "# Completion of trunk for bash, written by `trunk help --completion bash`.\n_trunk() {{\n"
      "    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= words=\n"
      "    ((COMP_CWORD > 1)) && command=${{COMP_WORDS[1]}}\n    case $command in\n"
      "        '') words={} ;;\n",
      shell_quoted(joined(first, " ")));
  for (const CommandRow& command : table.commands) out += bash_case(command);
  return out +
         "    esac\n    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}\ncomplete -o default -F _trunk "
         "trunk\n";
}

std::string zsh_completion(const CommandTable& table) {
  std::string commands, cases;
  for (const CommandRow& command : table.commands) {
    commands += "        " + shell_quoted(command.name + ":" + zsh_text(command.text)) + "\n";
    cases += "        " + command.name + ") _arguments";
    for (const OptionRow& row : command.options) cases += " \\\n            " + zsh_spec(row);
    cases += " ;;\n";
  }
  std::string options;
  for (const OptionRow& row : table.program.options) options += zsh_spec(row) + " ";
  return "#compdef trunk\n# Completion of trunk for zsh, written by `trunk help --completion zsh`.\n_trunk() "
         "{\n"
         "    local state\n    local -a commands\n    commands=(\n" +
         commands + "    )\n    _arguments -C " + options +
         "'1: :->command' '*:: :->arguments'\n"
         "    case $state in\n    command) _describe command commands ;;\n    arguments)\n"
         "        case $words[1] in\n" +
         cases + "        esac ;;\n    esac\n}\n_trunk \"$@\"\n";
}

std::string fish_completion(const CommandTable& table) {
  std::string out =
      "# Completion of trunk for fish, written by `trunk help --completion fish`.\n"
      "complete -c trunk -n __fish_use_subcommand -f\n";
  const auto options = [&](const CommandRow& command, const std::string& condition) {
    for (const OptionRow& row : command.options) {
      std::string line = "complete -c trunk -n " + shell_quoted(condition);
      for (const std::string& name : row.is_argument ? std::vector<std::string>{} : row.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!row.choices.empty())
        line += " -x -a " + shell_quoted(joined(row.choices, " "));
      else if (!row.value.empty())
        line += " -r -F";
      if (!row.is_argument) line += " -d " + shell_quoted(first_sentence(row.text));
      if (!row.is_argument || !row.choices.empty()) out += line + "\n";
    }
  };
  options(table.program, "__fish_use_subcommand");
  for (const CommandRow& command : table.commands) {
    out += fmt::format("complete -c trunk -n __fish_use_subcommand -a {} -d {}\n", command.name,
                       shell_quoted(first_sentence(command.text)));
    options(command, "__fish_seen_subcommand_from " + command.name);
  }
  return out;
}

}  // namespace trunk
