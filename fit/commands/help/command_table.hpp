#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace trunk {

/// An option or argument of a command. Help, manual page and completions all come from this.
struct OptionRow {
  std::vector<std::string> names;    ///< "-o", "--output"; of an argument its one name, "SCENARIO"
  std::string value;                 ///< what stands for the value, "FILE"; empty for a flag and an argument
  std::vector<std::string> choices;  ///< all values that are allowed; empty: any
  std::string text, group;
  bool is_argument = false, required = false, repeated = false;

  /// Returns "-o, --output FILE", with the choices in the place of the value if there are any.
  std::string label() const;
  /// Returns the value as a label shows it: "FILE", "joint|trace|scenario", "" for a flag.
  std::string value_label() const;
};

/// One command, or the program itself.
struct CommandRow {
  std::string name;                ///< "fit"; of the program "trunk"
  std::string group;               ///< the heading under which the program's help lists it
  std::string text;                ///< whole sentences; the first one is the summary
  std::vector<OptionRow> options;  ///< arguments first, the others by group
  std::string notes;  ///< what follows the options; a line that begins with two blanks is kept as it is

  std::string usage() const;
};

struct CommandTable {
  CommandRow program;
  std::vector<CommandRow> commands;

  /// Returns the command, or null if there is none of this name.
  const CommandRow* find(const std::string& name) const;
};

/// Returns the table of a program whose commands are all added.
CommandTable command_table(const CLI::App& program);

/// Returns the first sentence of a text, without its full stop.
std::string first_sentence(const std::string& text);

}  // namespace trunk
