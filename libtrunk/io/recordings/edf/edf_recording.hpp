#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "recordings/recording.hpp"

namespace trunk {

/// Returns whether a file that starts with these bytes (at least 256, if it has them) is EDF, EDF+, BDF or
/// BDF+.
bool is_edf(std::string_view start);

/// Opens an EDF or BDF file and ignores its annotations. Of an EDF+D or BDF+D file, `block` is the number of
/// an uninterrupted part; 0 takes the longest one, and a note says so. Throws InputError if the header breaks
/// the format, if the file is shorter or longer than its header says, or if there is no such part.
std::unique_ptr<Recording> open_edf(const std::filesystem::path& path, std::size_t block = 0);

}  // namespace trunk
