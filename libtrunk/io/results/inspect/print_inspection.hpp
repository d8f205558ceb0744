#pragma once

#include <filesystem>
#include <string>

namespace trunk {

/// What `trunk inspect` prints: kind, title, status, origin, parameters with their uncertainty,
/// measures, datasets with shape and unit. All data are read through, so that damage is found.
/// Throws InputError when the file is not a finished results file of trunk, or is damaged.
std::string inspection_text(const std::filesystem::path& path);

/// The same as one JSON object, schema "trunk.inspect/1"; NaN becomes null.
std::string inspection_json(const std::filesystem::path& path);

}  // namespace trunk
