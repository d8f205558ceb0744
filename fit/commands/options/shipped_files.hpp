#pragma once

#include <filesystem>

namespace trunk {

/// A file or folder that ships with the program, by its place in the source tree ("reference/table1.csv"):
/// beside the folder of the program itself, else in the working directory. Throws InputError that names both
/// places and the option that says another.
std::filesystem::path shipped_file(const std::filesystem::path& place, const char* option);

/// The folder, where there is one. Throws InputError.
std::filesystem::path require_folder(const std::filesystem::path& folder);

}  // namespace trunk
