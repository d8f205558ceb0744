#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// Returns the version of this program and what it was given. `inputs` are files to hash; `argv` is the
/// command line as typed. Throws InputError if a file cannot be read.
Provenance provenance_of(const std::vector<std::filesystem::path>& inputs, const std::string& argv);

/// Returns the lines of `trunk --version`: program, commit, compiler and libraries.
std::string version_text();

}  // namespace trunk
