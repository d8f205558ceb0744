#pragma once

#include <filesystem>
#include <string>

namespace trunk {

/// Returns the text that `trunk inspect` prints: kind, title, status, origin, parameters with their
/// uncertainty, measures, and datasets with shape and unit. Reads all data, so that it finds any damage.
/// Throws InputError if the file is not a finished results file of trunk, or if it is damaged.
std::string inspection_text(const std::filesystem::path& path);

/// Returns the same as a JSON object of schema "trunk.inspect/1". NaN becomes null.
std::string inspection_json(const std::filesystem::path& path);

}  // namespace trunk
