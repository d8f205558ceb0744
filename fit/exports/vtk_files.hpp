#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "exports/named_text.hpp"
#include "results/records.hpp"

namespace trunk {

/// The trajectory as VTK's XML, which every ParaView reads: trunk.pvd, the list of frames over time, and
/// frames/frame_00000.vtp … with points (m), velocity, displacement from the first frame, contact and region
/// of each particle, and the component of each triangle and fibre. Format: "VTK file formats", docs.vtk.org.
/// Throws InputError, naming `file`, where it has no trajectory.
std::vector<NamedText> vtk_files(const Trajectory& trajectory, const std::string& file);

/// One surface with numbers a point, as VTK's XML. points: [n*3] m; columns: each [n].
std::string surface_vtp(std::span<const double> points,
                        const std::vector<std::array<std::int32_t, 3>>& triangles,
                        const std::vector<NamedColumn>& columns);

}  // namespace trunk
