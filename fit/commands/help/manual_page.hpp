#pragma once

#include "commands/help/command_table.hpp"

namespace trunk {

/// Returns the manual page of the program and all its commands, for `man` (macros of man(7)). `version` is a
/// single line.
std::string manual_page(const CommandTable& table, const std::string& version);

}  // namespace trunk
