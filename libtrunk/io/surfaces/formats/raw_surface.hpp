#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// A surface as a file has it: its unit, its axes, nothing repaired. Every corner is a point, every
/// coordinate finite.
struct RawSurface {
  std::string format;               // "STL, binary"
  std::string axes, unit;           // "LPS", "mm", where the file itself says so; else empty
  std::vector<Vec3d> points;        // [points] in the unit of the file
  std::vector<Triangle> triangles;  // polygons are cut into fans
  std::vector<int> part;            // [triangles] index into parts
  std::vector<std::string> parts;   // names of groups, solids, components; one at least
};

/// The most that is read: our choice, a hundred times what a segmented trunk has.
inline constexpr std::size_t most_surface_points = 3'000'000, most_surface_triangles = 3'000'000;
inline constexpr std::size_t largest_surface_file = 200'000'000;  // bytes

/// Takes the points and polygons of a file one by one. `file` is for messages; line 0 where it has none.
class SurfaceBuilder {
 public:
  SurfaceBuilder(std::string file, std::string format) : file_(std::move(file)) {
    surface_.format = std::move(format);
  }

  /// Throws InputError for a coordinate that is not finite, and for more than the most.
  void point(const Vec3d& p, std::size_t line = 0);
  std::size_t points() const noexcept { return surface_.points.size(); }

  /// Corners by index, cut into a fan; fewer than three corners are dropped. Throws InputError unless each is
  /// one of `end` points (by default those so far).
  void polygon(std::span<const double> corners, std::size_t line = 0) { polygon(corners, line, points()); }
  void polygon(std::span<const double> corners, std::size_t line, std::size_t end);

  /// Triangles that share two corners with the one before, by index.
  void strip(std::span<const double> corners, std::size_t line = 0);

  /// Polygons or strips as VTK lists them: the corners of all, and where each one ends. Throws InputError.
  void cells(std::span<const double> corners, std::span<const double> ends, bool strips);

  /// What follows belongs to a part of that name.
  void begin_part(std::string_view name);

  /// What a comment or title says: "SPACE=LPS" as 3D Slicer writes it.
  void remark(std::string_view text);
  void unit(std::string name) { surface_.unit = std::move(name); }

  /// The finished surface. Throws InputError without triangles.
  RawSurface finish();

  [[noreturn]] void fail(std::size_t line, const std::string& text) const;

 private:
  std::string file_;
  RawSurface surface_;
  int current_part_ = -1;
};

/// One a format; `bytes` is the whole file, `file` its name for messages. All throw InputError.
RawSurface read_stl(const std::string& bytes, const std::string& file);
RawSurface read_obj(const std::string& bytes, const std::string& file);
RawSurface read_ply(const std::string& bytes, const std::string& file);
RawSurface read_vtk(const std::string& bytes, const std::string& file);  // legacy
RawSurface read_vtp(const std::string& bytes, const std::string& file);
RawSurface read_pml_surface(const std::string& bytes, const std::string& file);

/// Whatever the format is: known by the content, not by the name of the file.
RawSurface read_raw_surface(std::string bytes, const std::string& file);

}  // namespace trunk
