#pragma once

#include "commands/help/command_table.hpp"

namespace trunk {

/// Returns what `trunk --help` prints: the commands by group, the options, the notes.
std::string program_help(const CommandTable& table);

/// Returns what `trunk COMMAND --help` prints.
std::string command_help(const CommandRow& command);

}  // namespace trunk
