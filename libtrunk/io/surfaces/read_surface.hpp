#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surface/repair.hpp"

namespace trunk {

/// What a user says about a surface. Empty members are taken from the file, or guessed.
struct SurfaceOptions {
  std::string unit;            // mm, cm or m
  std::string axes;            // as for Axes: "RAS"
  std::string component;       // name of the only part to read, in PML, OBJ or STL
  std::string axes_of_others;  // axes of the subject's other surfaces; they are used instead of a guess
};

/// A measured surface from a file, in m and in the axes of the trunk, with a report of what was chosen,
/// repaired and guessed.
struct ImportedSurface {
  MeasuredSurface surface;  // its name is the name of the file
  std::string format, unit, axes;
  bool axes_guessed = false;       // from the shape, since neither user, file nor another surface says them
  bool axes_assumed = false;       // the shape does not show them either
  RepairReport repaired;           // sheet_thickness and island_distance in m
  std::vector<std::string> notes;  // one sentence each, for the user; an assumption about axes comes first
};

/// Reads a surface in STL, OBJ, PLY, VTK, VTP, VTU or PML, packed with gzip or not, which it recognises by
/// the content. Repairs the surface and converts it to m and to the axes of the trunk.
///
/// If neither the user nor the file names the unit, the unit follows from the size, because a part of a human
/// trunk is 0.05 to 1 m long. If neither names the axes, they are guessed from the shape of an open dome, or
/// assumed to be RAS for other shapes. The notes report both.
///
/// Throws InputError if the file cannot be read, has no triangles, is flat, does not have the size of a part
/// of a trunk, or has no component of the chosen name.
ImportedSurface read_surface(const std::filesystem::path& path, const SurfaceOptions& options = {});

}  // namespace trunk
