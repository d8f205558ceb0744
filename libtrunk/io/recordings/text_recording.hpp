#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "recordings/recording.hpp"

namespace trunk {

/// Returns a text table (see DelimitedText), or a text of LabChart or AcqKnowledge, as a recording. If the
/// first filled cell of a column is a clock time, the column is read in seconds since its first time, and its
/// unit is "s". Cells without a number are flaws. Comments at the ends of rows become a note.
///
/// `block` is the part of a LabChart text (see labchart_layout); 0 leaves the choice to the program. Throws
/// as DelimitedText and the layouts do, for more than 10000 flaws, and if a text without blocks is to be read
/// from another than the first.
std::unique_ptr<Recording> recording_of_text(std::string source, std::string text, std::size_t block = 0);

}  // namespace trunk
