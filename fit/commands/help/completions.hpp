#pragma once

#include "commands/help/command_table.hpp"

namespace trunk {

/// Each returns a script that makes a shell complete commands, options and those values that come from a
/// list; for every other value the shell offers files.
std::string bash_completion(const CommandTable& table);
std::string zsh_completion(const CommandTable& table);
std::string fish_completion(const CommandTable& table);

}  // namespace trunk
