#include "commands/help/manual_page.hpp"

#include <fmt/format.h>

#include <sstream>

namespace trunk {
namespace {

/// The text as roff prints it: a hyphen that can be copied, and no line that roff takes for a request.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string option_entry(const OptionRow& row) {
  std::string names;
  for (const std::string& name : row.names) names += (names.empty() ? "" : ", ") + bold(name);
  if (!row.value.empty()) names += " \\fI" + escaped(row.value_label()) + "\\fR";
  return ".TP\n" + names + "\n" + escaped(row.text) + "\n";
}

std::string notes_text(const std::string& notes) {
  std::string out = notes.empty() ? "" : ".PP\n";
  bool kept = false;  // lines as they are
  std::istringstream lines(notes);
  for (std::string line; std::getline(lines, line);) {
    const bool keep = line.starts_with("  ");
    if (keep != kept) out += keep ? ".nf\n" : ".fi\n";
    kept = keep;
    out += line.empty() ? ".PP\n" : escaped(line) + "\n";
  }
  return out + (kept ? ".fi\n" : "");
}

std::string command_section(const CommandRow& command) {
  std::string out = ".SS " + escaped(command.usage()) + "\n" + escaped(command.text) + "\n";
  for (const OptionRow& row : command.options) out += option_entry(row);
  return out + notes_text(command.notes);
}

}  // namespace

std::string manual_page(const CommandTable& table, const std::string& version) {
  const CommandRow& program = table.program;
  std::string out = fmt::format(".TH TRUNK 1 \"\" \"{}\" \"User Commands\"\n.ad l\n.nh\n", escaped(version));
  out += ".SH NAME\n" + fmt::format("trunk \\- {}\n", escaped(first_sentence(program.text)));
  out += ".SH SYNOPSIS\n" + bold("trunk") + " \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n";
  out += ".SH DESCRIPTION\n" + escaped(program.text) + "\n";
  out += ".SH OPTIONS\n";
  for (const OptionRow& row : program.options) out += option_entry(row);
  out += ".SH COMMANDS\n";
  for (const CommandRow& command : table.commands) out += command_section(command);
  return out + ".SH NOTES\n" + notes_text(program.notes);
}

}  // namespace trunk
