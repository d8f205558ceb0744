#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// What this program is and what it was given. `inputs` are files to hash. `argv` is the command line as
/// typed.
Provenance provenance_of(const std::vector<std::filesystem::path>& inputs, const std::string& argv);

/// Several lines: program, commit, compiler and libraries, as `trunk --version` prints them.
std::string version_text();

}  // namespace trunk
