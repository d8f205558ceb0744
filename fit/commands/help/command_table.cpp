#include "commands/help/command_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace trunk {
namespace {

/// What CLI11 calls a value by its type, in the words of our help.
std::string value_name(const std::string& type) {
  if (type == "INT" || type == "UINT") return "N";
  return type == "FLOAT" ? "NUMBER" : type;
}

OptionRow option_row(const CLI::Option& option) {
  OptionRow row;
  row.is_argument = option.get_positional();
  if (row.is_argument) row.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  // CLI11 describes a value as "TEXT:{one,other}": its type, then what each check says of it.
  const std::string described = option.get_type_name();
  if (!row.is_argument && option.get_items_expected_max() > 0)
    row.value = value_name(described.substr(0, described.find(":{")));
  if (const std::size_t open = described.find(":{"); open != std::string::npos)
    row.choices = CLI::detail::split(described.substr(open + 2, described.find('}', open) - open - 2), ',');
  row.text = option.get_description();
  row.group = row.is_argument ? "Arguments" : option.get_group();
  row.required = option.get_required();
  row.repeated = option.get_items_expected_max() > 1;
  return row;
}

/// Arguments come first, then options without a group, --help as the last of them. The other groups stand in
/// the order in which the command adds them.
std::vector<OptionRow> option_rows(const CLI::App& command) {
  std::vector<OptionRow> rows;
  std::vector<std::string> groups{"Arguments", "Options"};
  for (const CLI::Option* option : command.get_options()) {
    if (option == command.get_help_ptr()) continue;
    rows.push_back(option_row(*option));
    if (std::find(groups.begin(), groups.end(), rows.back().group) == groups.end())
      groups.push_back(rows.back().group);
  }
  rows.push_back(option_row(*command.get_help_ptr()));
  const auto place = [&](const OptionRow& row) {
    return std::find(groups.begin(), groups.end(), row.group) - groups.begin();
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const OptionRow& a, const OptionRow& b) { return place(a) < place(b); });
  return rows;
}

CommandRow command_row(const CLI::App& command) {
  return {command.get_name(), command.get_group(), command.get_description(), option_rows(command),
          command.get_footer()};
}

}  // namespace

std::string OptionRow::value_label() const {
  return choices.empty() || value.empty() ? value : fmt::format("{}", fmt::join(choices, "|"));
}

std::string OptionRow::label() const {
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  return value.empty() ? all : all + " " + value_label();
}

std::string CommandRow::usage() const {
  if (name == "trunk") return "trunk COMMAND [OPTIONS]";
  std::string line = "trunk " + name;
  for (const OptionRow& row : options) {
    if (!row.is_argument && !row.required) continue;
    const std::string one =
        (row.is_argument ? row.names.front() : row.names.front() + " " + row.value_label()) +
        (row.is_argument && row.repeated ? "..." : "");
    line += row.required ? " " + one : " [" + one + "]";
  }
  return line + " [OPTIONS]";
}

const CommandRow* CommandTable::find(const std::string& name) const {
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const CommandRow& row) { return row.name == name; });
  return found == commands.end() ? nullptr : &*found;
}

CommandTable command_table(const CLI::App& program) {
  CommandTable table{command_row(program), {}};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    table.commands.push_back(command_row(*command));
  return table;
}

std::string first_sentence(const std::string& text) {
  const std::size_t end = text.find(". ");
  if (end != std::string::npos) return text.substr(0, end);
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

}  // namespace trunk
