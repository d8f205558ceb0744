#include "surfaces/formats/raw_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "errors/input_error.hpp"
#include "surfaces/formats/other_formats.hpp"
#include "surfaces/formats/words.hpp"

namespace trunk {

void SurfaceBuilder::fail(std::size_t line, std::string found, std::string expected,
                          std::string remedy) const {
  throw InputError({file_, line}, std::move(found), std::move(expected), std::move(remedy));
}

void SurfaceBuilder::point(const Vec3d& p, std::size_t line) {
  if (points() >= most_surface_points)
    fail(line, "too many points found", fmt::format("at most {}", most_surface_points), "thin the surface");
  for (const double x : {p.x(), p.y(), p.z()})
    if (!(std::abs(x) < 1e12))
      fail(line, fmt::format("coordinate {} of point {} found", x, points()), "a finite length",
           "remove or correct it");
  surface_.points.push_back(p);
}

void SurfaceBuilder::polygon(std::span<const double> corners, std::size_t line, std::size_t end) {
  for (const double corner : corners)
    if (!(corner >= 0.0 && corner < static_cast<double>(end) && corner == std::floor(corner)))
      fail(line,
           fmt::format("a polygon has corner {} (counted from 0), but there are {} points", corner, end),
           "one of these points", "export the surface again");
  if (current_part_ < 0) begin_part("");
  for (std::size_t i = 2; i < corners.size(); ++i) {
    if (surface_.triangles.size() >= most_surface_triangles)
      fail(line, "too many triangles found", fmt::format("at most {}", most_surface_triangles),
           "thin the surface");
    surface_.triangles.push_back(
        {static_cast<int>(corners[0]), static_cast<int>(corners[i - 1]), static_cast<int>(corners[i])});
    surface_.part.push_back(current_part_);
  }
}

void SurfaceBuilder::strip(std::span<const double> corners, std::size_t line) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool odd = i % 2 == 1;
    polygon(std::array{corners[odd ? i - 1 : i - 2], corners[odd ? i - 2 : i - 1], corners[i]}, line);
  }
}

template <class Add>
void SurfaceBuilder::for_each_cell(std::span<const double> corners, std::span<const double> ends, Add&& add) {
  double begin = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double end = ends[i];
    if (!(end >= begin && end <= static_cast<double>(corners.size())))
      fail(0, fmt::format("a polygon's corners end at {} in a list of {}", end, corners.size()),
           "increasing ends within the list", "export the surface again");
    add(corners.subspan(static_cast<std::size_t>(begin),
                        static_cast<std::size_t>(end) - static_cast<std::size_t>(begin)),
        i);
    begin = end;
  }
}

void SurfaceBuilder::cells(std::span<const double> corners, std::span<const double> ends, bool strips) {
  for_each_cell(corners, ends,
                [&](std::span<const double> cell, std::size_t) { strips ? strip(cell) : polygon(cell); });
}

void SurfaceBuilder::one_cell(std::span<const double> corners, double type) {
  enum : int {
    most_lines = 4,
    triangle = 5,
    triangle_strip = 6,
    any_polygon = 7,
    pixel = 8,
    quadrilateral = 9
  };
  const int kind = type >= 0.0 && type < 256.0 ? static_cast<int>(type) : -1;
  if (kind >= 0 && kind <= most_lines) return;
  if (kind == triangle || kind == any_polygon || kind == quadrilateral) return polygon(corners);
  if (kind == triangle_strip) return strip(corners);
  if (kind == pixel && corners.size() == 4)  // its corners go row by row
    return polygon(std::array{corners[0], corners[1], corners[3], corners[2]});
  fail(0, fmt::format("a cell of VTK's type {} found, which is no flat triangle or polygon", type),
       "triangles, strips, polygons, pixels or quadrilaterals",
       "extract the surface and save that (ParaView: Extract Surface, then Triangulate)");
}

void SurfaceBuilder::cells(std::span<const double> corners, std::span<const double> ends,
                           std::span<const double> types) {
  if (types.size() != ends.size())
    fail(0, fmt::format("{} cells and {} types of cells found", ends.size(), types.size()), "as many",
         "export the surface again");
  for_each_cell(corners, ends,
                [&](std::span<const double> cell, std::size_t i) { one_cell(cell, types[i]); });
}

void SurfaceBuilder::begin_part(std::string_view name) {
  constexpr std::size_t most_parts = 1000;
  auto& parts = surface_.parts;
  const auto known = std::find(parts.begin(), parts.end(), name);
  current_part_ = static_cast<int>(known - parts.begin());
  if (known != parts.end()) return;
  if (parts.size() < most_parts)
    parts.emplace_back(name.substr(0, 200));
  else
    current_part_ = static_cast<int>(most_parts - 1);
}

void SurfaceBuilder::axes(std::string_view name) {
  constexpr const char* around = " \t\r\n\"'";
  const std::size_t begin = name.find_first_not_of(around);
  if (begin >= name.size() || name[begin] == '\0') return;
  surface_.axes = name.substr(begin, name.find_first_of(std::string(around) + '\0', begin) - begin);
}

void SurfaceBuilder::remark(std::string_view text) {
  constexpr std::string_view key = "SPACE=";
  const std::size_t at = text.find(key);
  if (at != std::string_view::npos) axes(text.substr(at + key.size()));
}

RawSurface SurfaceBuilder::finish() {
  if (surface_.triangles.empty())
    fail(0, fmt::format("{} file with {} points and no triangle", surface_.format, points()),
         "a surface of triangles or polygons", "export it as one");
  return std::move(surface_);
}

namespace {

/// Returns whether the first line that is not a comment is a statement of OBJ.
bool looks_like_obj(std::string_view text) {
  Words words(text, "");
  while (!words.at_end()) {
    const std::string_view first = words.word_of_line();
    for (const char* statement :
         {"v", "vn", "vt", "vp", "f", "o", "g", "s", "l", "p", "mg", "mtllib", "usemtl", "cstype", "deg"})
      if (first == statement) return true;
    if (!first.empty() && first.front() != '#') return false;
    words.skip_line();
  }
  return false;
}

}  // namespace

RawSurface read_raw_surface(std::string bytes, const std::string& file) {
  if (bytes.starts_with("\x1F\x8B")) bytes = gunzipped(bytes, file);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  refuse_other_formats(bytes, file);
  const std::string_view text = bytes;
  const std::string_view head = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()), 2000);
  const auto begins = [&](std::string_view with) {
    return head.size() >= with.size() &&
           std::equal(with.begin(), with.end(), head.begin(), [](char a, char b) {
             return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b);
           });
  };
  if (begins("<"))
    return head.find("<VTKFile") < head.size() ? read_vtp(bytes, file) : read_pml_surface(bytes, file);
  if (begins("# vtk datafile")) return read_vtk(bytes, file);
  if (begins("ply")) return read_ply(bytes, file);
  if (is_binary_stl(bytes) || begins("solid") || begins("facet")) return read_stl(bytes, file);
  if (looks_like_obj(text)) return read_obj(bytes, file);
  throw InputError({file}, "the format is not known", "a surface in STL, OBJ, PLY, VTK, VTP, VTU or PML",
                   "open it in 3D Slicer, MeshLab or ParaView and save it as one of these");
}

}  // namespace trunk
