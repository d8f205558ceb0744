#include "surfaces/formats/raw_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "errors/input_error.hpp"
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

void SurfaceBuilder::cells(std::span<const double> corners, std::span<const double> ends, bool strips) {
  double begin = 0.0;
  for (const double end : ends) {
    if (!(end >= begin && end <= static_cast<double>(corners.size())))
      fail(0, fmt::format("a polygon's corners end at {} in a list of {}", end, corners.size()),
           "increasing ends within the list", "export the surface again");
    const auto cell = corners.subspan(static_cast<std::size_t>(begin),
                                      static_cast<std::size_t>(end) - static_cast<std::size_t>(begin));
    strips ? strip(cell) : polygon(cell);
    begin = end;
  }
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

void SurfaceBuilder::remark(std::string_view text) {
  for (const char* axes : {"LPS", "RAS"})
    if (text.find(std::string("SPACE=") + axes) != std::string_view::npos) surface_.axes = axes;
}

RawSurface SurfaceBuilder::finish() {
  if (surface_.triangles.empty())
    fail(0, fmt::format("{} file with {} points and no triangle", surface_.format, points()),
         "a surface of triangles or polygons", "export it as one");
  return std::move(surface_);
}

namespace {

bool looks_like_obj(std::string_view text) {
  Words words(text, "");
  for (int lines = 0; lines < 200 && !words.at_end(); ++lines) {
    const std::string_view first = words.word_of_line();
    for (const char* statement : {"v", "vn", "vt", "vp", "f", "o", "g", "s", "l", "p", "mtllib", "usemtl"})
      if (first == statement) return true;
    if (!first.empty() && first.front() != '#') return false;
    words.skip_line();
  }
  return false;
}

}  // namespace

RawSurface read_raw_surface(std::string bytes, const std::string& file) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
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
  throw InputError({file}, "the format is not known", "a surface in STL, OBJ, PLY, VTK, VTP or PML");
}

}  // namespace trunk
