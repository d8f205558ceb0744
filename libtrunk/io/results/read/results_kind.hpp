#pragma once

#include <filesystem>
#include <string>

namespace trunk {

/// Returns whether `path` is a finished results file; false, and no error, for anything else.
bool is_complete(const std::filesystem::path& path);

/// Returns "run", "fit" or "sweep"; throws InputError if the file is not a finished results file.
std::string kind_of(const std::filesystem::path& path);

}  // namespace trunk
