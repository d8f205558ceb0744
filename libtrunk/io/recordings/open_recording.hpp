#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "recordings/recording.hpp"

namespace trunk {

/// What a file does not say about itself.
struct RecordingOptions {
  std::string encoding;   ///< of a text, as iconv calls it; empty: see utf8_of
  std::size_t block = 0;  ///< of a text of LabChart or an interrupted EDF+ file, from 1; 0: the longest
};

/// Opens a file of recorded channels and recognises its format by the content: a MAT-file, EDF or BDF, or
/// else a text of at most 200 MB. Throws InputError if the file cannot be read, or if it has another known
/// format (see require_no_foreign_format).
std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                          const RecordingOptions& options = {});

}  // namespace trunk
