#pragma once

#include <filesystem>

namespace trunk {

/// Writes a file of a few hundred bytes that lets ParaView (from 5.12) and VTK (from 9.3) show the trajectory
/// of a run or fit. The file holds only a link to the trajectory, relative to the folder of `view`. Throws
/// std::runtime_error with the path and the cause.
void write_vtkhdf_view(const std::filesystem::path& view, const std::filesystem::path& results);

}  // namespace trunk
