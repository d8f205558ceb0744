#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "errors/input_error.hpp"
#include "scenarios/build_trunk.hpp"
#include "support/temporary_folder.hpp"

namespace trunk::test {

/// The message about a scenario, read and built as the program does.
inline std::string message_of(const std::filesystem::path& path,
                              const std::vector<std::string>& settings = {}) {
  try {
    build_trunk(read_scenario(path, settings));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The message about a text saved as bad.toml.
inline std::string message_about(const std::string& text) {
  TemporaryFolder folder;
  return message_of(folder.write("bad.toml", text));
}

}  // namespace trunk::test
