#include "commands/help/help_text.hpp"

#include <algorithm>
#include <sstream>

namespace trunk {
namespace {

constexpr std::size_t width = 80, text_column = 30;

/// Appends the words of `text` to a line that is `at` wide so far; later lines begin at `indent`.
void append_words(std::string& out, const std::string& text, std::size_t at, std::size_t indent) {
  std::istringstream words(text);
  bool first = true;
  for (std::string word; words >> word; first = false) {
    if (!first && at + 1 + word.size() > width) {
      out += "\n" + std::string(indent, ' ');
      at = indent;
    } else if (!first) {
      out += ' ';
      ++at;
    }
    out += word;
    at += word.size();
  }
  out += '\n';
}

/// Appends a label and, in a second column, its meaning. A long label has a line of its own.
void append_entry(std::string& out, const std::string& label, const std::string& text) {
  std::string line = "  " + label;
  if (line.size() + 2 > text_column) {
    out += line + "\n";
    line.clear();
  }
  line.resize(text_column, ' ');
  out += line;
  append_words(out, text, text_column, text_column);
}

void append_options(std::string& out, const std::vector<OptionRow>& options) {
  std::string group;
  for (const OptionRow& row : options) {
    if (row.group != group) out += "\n" + row.group + ":\n";
    group = row.group;
    append_entry(out, row.label(), row.text);
  }
}

void append_notes(std::string& out, const std::string& notes) {
  if (notes.empty()) return;
  out += '\n';
  std::istringstream lines(notes);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  "))
      out += line + "\n";
    else
      append_words(out, line, 0, 0);
}

std::string head(const CommandRow& row) {
  std::string out = "Usage: " + row.usage() + "\n\n";
  append_words(out, row.text, 0, 0);
  return out;
}

}  // namespace

std::string program_help(const CommandTable& table) {
  std::string out = head(table.program), group;
  for (const CommandRow& command : table.commands) {
    if (command.group != group) out += "\n" + command.group + ":\n";
    group = command.group;
    append_entry(out, command.name, first_sentence(command.text) + ".");
  }
  append_options(out, table.program.options);
  append_notes(out, table.program.notes);
  return out;
}

std::string command_help(const CommandRow& command) {
  std::string out = head(command);
  append_options(out, command.options);
  append_notes(out, command.notes);
  return out;
}

}  // namespace trunk
