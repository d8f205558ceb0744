#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "recordings/recording.hpp"

namespace trunk {

/// Returns whether a file that starts with these bytes (at least 256, if it has them) is EDF, EDF+, BDF or
/// BDF+.
bool is_edf(std::string_view start);

/// Opens an EDF or BDF file and ignores its annotations. Throws InputError if the header breaks the format,
/// if the file is shorter or longer than its header says, or if the recording has interruptions.
std::unique_ptr<Recording> open_edf(const std::filesystem::path& path);

}  // namespace trunk
