#pragma once

#include <filesystem>

namespace trunk {

/// Returns a file or folder that ships with the program, by its place in the source tree
/// ("reference/table1.csv"). It is looked for beside the folder of the program, then in the working
/// directory. Throws InputError that names both places and the option that gives another.
std::filesystem::path shipped_file(const std::filesystem::path& place, const char* option);

/// Returns the folder; throws InputError if there is none.
std::filesystem::path require_folder(const std::filesystem::path& folder);

}  // namespace trunk
