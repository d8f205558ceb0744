#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "recordings/recording.hpp"

namespace trunk {

/// Whether a file that starts with these bytes (256 where it has them) is EDF, EDF+, BDF or BDF+.
bool is_edf(std::string_view start);

/// Opens an EDF or BDF file; annotations are left out. Throws InputError: a header that breaks the format, a
/// file shorter or longer than its header says, a recording with interruptions.
std::unique_ptr<Recording> open_edf(const std::filesystem::path& path);

}  // namespace trunk
