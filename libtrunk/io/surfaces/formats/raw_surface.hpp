#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// The unrepaired surface of a file, in the unit and the axes of the file. Every corner is an existing point,
/// and every coordinate is finite.
struct RawSurface {
  std::string format;               // "STL, binary"
  std::string axes, unit;           // "LPS", "mm"; empty if the file does not say it
  std::vector<Vec3d> points;        // [points] in the unit of the file
  std::vector<Triangle> triangles;  // polygons are split into fans
  std::vector<int> part;            // [triangles] index into parts
  std::vector<std::string> parts;   // names of groups, solids or components; at least one
};

/// The largest surface that is read. Our choice: a hundred times the size of a segmented trunk.
inline constexpr std::size_t most_surface_points = 3'000'000, most_surface_triangles = 3'000'000;
inline constexpr std::size_t largest_surface_file = 200'000'000;  // bytes

/// Collects the points and polygons of a file. Messages name `file` and the line, unless the line is 0.
class SurfaceBuilder {
 public:
  SurfaceBuilder(std::string file, std::string format) : file_(std::move(file)) {
    surface_.format = std::move(format);
  }

  /// Adds a point; throws InputError if a coordinate is not finite or if there are too many points.
  void point(const Vec3d& p, std::size_t line = 0);
  std::size_t points() const noexcept { return surface_.points.size(); }

  /// Adds a polygon with corners by index, split into a fan. A polygon of fewer than three corners is
  /// dropped. Throws InputError unless each corner is one of `end` points, by default of the points added so
  /// far.
  void polygon(std::span<const double> corners, std::size_t line = 0) { polygon(corners, line, points()); }
  void polygon(std::span<const double> corners, std::size_t line, std::size_t end);

  /// Adds triangles of which each shares two corners with the one before. Corners are given by index.
  void strip(std::span<const double> corners, std::size_t line = 0);

  /// Adds polygons or strips as VTK lists them: the corners of all of them, and the end of each in this list.
  /// Throws InputError.
  void cells(std::span<const double> corners, std::span<const double> ends, bool strips);
  /// The same for cells of several types, by VTK's numbers: triangles, strips, polygons, pixels and
  /// quadrilaterals are added; points and lines are left out. Throws InputError for all other types.
  void cells(std::span<const double> corners, std::span<const double> ends, std::span<const double> types);

  /// Begins a part: later polygons belong to the part of that name.
  void begin_part(std::string_view name);

  /// Takes the axes from a comment or title, where 3D Slicer writes "SPACE=LPS".
  void remark(std::string_view text);
  /// Takes the axes as the file names them, such as "LPS".
  void axes(std::string_view name);
  void unit(std::string name) { surface_.unit = std::move(name); }

  /// Returns the surface; throws InputError if it has no triangles.
  RawSurface finish();

  /// Throws InputError at a line.
  [[noreturn]] void fail(std::size_t line, std::string found, std::string expected = "",
                         std::string remedy = "") const;

 private:
  std::string file_;
  RawSurface surface_;
  int current_part_ = -1;

  void one_cell(std::span<const double> corners, double type);
  template <class Add>
  void for_each_cell(std::span<const double> corners, std::span<const double> ends, Add&& add);
};

/// Readers of one format each. `bytes` is the whole file, and messages name `file`. All throw InputError.
RawSurface read_stl(const std::string& bytes, const std::string& file);
RawSurface read_obj(const std::string& bytes, const std::string& file);
RawSurface read_ply(const std::string& bytes, const std::string& file);
RawSurface read_vtk(const std::string& bytes, const std::string& file);  // legacy
RawSurface read_vtp(const std::string& bytes, const std::string& file);  // VTP, VTU and lists of them
RawSurface read_pml_surface(const std::string& bytes, const std::string& file);

/// Reads a surface in any of these formats, which it recognises by the content, also if it is packed with
/// gzip; throws InputError.
RawSurface read_raw_surface(std::string bytes, const std::string& file);

}  // namespace trunk
