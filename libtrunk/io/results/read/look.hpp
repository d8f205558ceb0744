#pragma once

#include <filesystem>
#include <string>

namespace trunk {

/// Returns what a file that is not HDF5 looks like according to its first bytes or its name, and which
/// command reads it: "TOML, perhaps a scenario …; see …".
std::string look_of(const std::filesystem::path& path);

}  // namespace trunk
