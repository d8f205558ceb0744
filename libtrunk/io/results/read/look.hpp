#pragma once

#include <filesystem>
#include <string>

namespace trunk {

/// What a file that is not HDF5 looks like, and which command takes it: "TOML, perhaps a scenario …; see …".
/// Goes by its first bytes or its name.
std::string look_of(const std::filesystem::path& path);

}  // namespace trunk
