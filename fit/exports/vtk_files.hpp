#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "exports/named_text.hpp"
#include "results/records.hpp"

namespace trunk {

/// Returns the trajectory as VTK's XML files, which ParaView reads. trunk.pvd lists the frames over time;
/// frames/frame_00000.vtp and so on hold points (m), velocity, displacement from the first frame, contact and
/// region of each particle, and the component of each triangle and fibre. Format: "VTK file formats",
/// docs.vtk.org. Throws InputError at `file` if there is no trajectory.
std::vector<NamedText> vtk_files(const Trajectory& trajectory, const std::string& file);

/// Returns one surface with numbers for each point, as VTK's XML. points: [n*3] m; columns: each [n].
std::string surface_vtp(std::span<const double> points,
                        const std::vector<std::array<std::int32_t, 3>>& triangles,
                        const std::vector<NamedColumn>& columns);

}  // namespace trunk
