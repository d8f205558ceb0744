#pragma once

#include <filesystem>
#include <memory>

#include "recordings/recording.hpp"

namespace trunk {

/// Opens a file of recorded channels by its content, whatever its name: a MAT-file, EDF or BDF, else a table
/// in text of at most 200 MB. Throws InputError: cannot be read, is another known format (spreadsheet,
/// archive, HDF5).
std::unique_ptr<Recording> open_recording(const std::filesystem::path& path);

}  // namespace trunk
