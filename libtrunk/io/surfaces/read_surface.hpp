#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surface/repair.hpp"

namespace trunk {

/// What a user says of a surface in a file; empty: the file says it, or it is guessed.
struct SurfaceOptions {
  std::string unit;            // mm, cm or m
  std::string axes;            // as Axes takes them
  std::string component;       // name of the one part to read: of PML, OBJ or STL
  std::string axes_of_others;  // of the subject's other surfaces: taken rather than guessed
};

/// A measured surface, and what was chosen, repaired and guessed on the way.
struct ImportedSurface {
  MeasuredSurface surface;  // named as the file
  std::string format, unit, axes;
  RepairReport repaired;           // sheet_thickness in m
  std::vector<std::string> notes;  // a sentence each, for the user
};

/// Reads a surface in STL, OBJ, PLY, VTK, VTP or PML, known by its content, and brings it into m and the
/// trunk's axes, repaired. A unit that nobody names is taken from the size: a part of a human trunk is 0.05
/// to 1 m. Axes that nobody names are guessed from the shape of an open dome and taken as RAS otherwise; the
/// notes say so. Throws InputError for a file that is not read, no triangles, a flat surface, a size that is
/// no trunk's, a component that is not there.
ImportedSurface read_surface(const std::filesystem::path& path, const SurfaceOptions& options = {});

}  // namespace trunk
