#pragma once

#include <filesystem>
#include <memory>

#include "recordings/recording.hpp"

namespace trunk {

/// Opens a file of recorded channels and recognises its format by the content: a MAT-file, EDF or BDF, or
/// else a text table of at most 200 MB. Throws InputError if the file cannot be read, or if it has another
/// known format, such as a spreadsheet, an archive or HDF5.
std::unique_ptr<Recording> open_recording(const std::filesystem::path& path);

}  // namespace trunk
