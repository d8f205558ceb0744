#pragma once

#include <filesystem>

namespace trunk {

/// A file of a few hundred bytes that shows the trajectory of a run or fit under a name that ParaView and VTK
/// (5.12 and 9.3 on) know, by a link to it: it holds nothing itself. The link is relative to the folder of
/// `view`. Throws std::runtime_error, one line.
void write_vtkhdf_view(const std::filesystem::path& view, const std::filesystem::path& results);

}  // namespace trunk
