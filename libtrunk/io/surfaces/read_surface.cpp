#include "surfaces/read_surface.hpp"

#include <algorithm>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "surface/axes.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

std::string counted(std::size_t count, const std::string& single, const std::string& several) {
  return std::to_string(count) + " " + (count == 1 ? single : several);
}

void keep_component(RawSurface& from, const std::string& name, const std::string& file) {
  const auto known = std::find(from.parts.begin(), from.parts.end(), name);
  const int wanted = static_cast<int>(known - from.parts.begin());
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < from.triangles.size(); ++i)
    if (from.part[i] == wanted) kept.push_back(from.triangles[i]);
  if (kept.empty()) {
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(from.parts.size(), 12); ++i)
      if (std::find(from.part.begin(), from.part.end(), static_cast<int>(i)) != from.part.end())
        names += " " + excerpt(from.parts[i]);
    throw InputError(file, 0,
                     "component " + excerpt(name) + " with triangles is not there; expected one of" + names);
  }
  from.triangles = std::move(kept);
}

struct LengthUnit {
  std::string name;
  double metres;
};

LengthUnit named_unit(const std::string& name, const std::string& file) {
  for (const LengthUnit& unit : {LengthUnit{"mm", 1e-3}, LengthUnit{"cm", 1e-2}, LengthUnit{"m", 1.0}})
    if (unit.name == name) return unit;
  throw InputError(file, 0, "unit " + excerpt(name) + " found; expected mm, cm or m; give --surface-unit");
}

/// By the largest extent: m up to 1, then cm, from 100 on mm (10 cm at least, as what moves in breathing is).
LengthUnit guessed_unit(double extent, const std::string& file) {
  if (extent >= 0.05 && extent <= 1.0) return {"m", 1.0};
  if (extent >= 5.0 && extent < 100.0) return {"cm", 1e-2};
  if (extent >= 100.0 && extent <= 1000.0) return {"mm", 1e-3};
  throw InputError(file, 0,
                   "the surface is " + number_text(extent) +
                       " units long; expected 0.05 to 1 m, the size of a part of a human trunk, in m, "
                       "cm or mm; scale it or give --surface-unit");
}

void choose_unit(ImportedSurface& result, const SurfaceOptions& options, const std::string& said_by_file,
                 const std::string& file) {
  const double extent = largest_extent(result.surface);
  const std::string& declared = options.unit.empty() ? said_by_file : options.unit;
  const LengthUnit unit = declared.empty() ? guessed_unit(extent, file) : named_unit(declared, file);
  if (const double size = extent * unit.metres; !(size >= 0.03 && size <= 2.0))
    throw InputError(file, 0,
                     "the surface is " + number_text(size) + " m long in " + unit.name +
                         "; expected 0.05 to 1 m, the size of a part of a human trunk; check the unit");
  result.unit = unit.name;
  result.repaired.sheet_thickness *= unit.metres;
  for (Vec3d& p : result.surface.points) p = unit.metres * p;
  if (options.unit.empty())
    result.notes.push_back("unit " + (said_by_file.empty()
                                          ? "taken as " + unit.name + ", since the surface is " +
                                                number_text(extent) + " long; --surface-unit says otherwise"
                                          : unit.name + ", as the file says"));
}

Axes chosen_axes(ImportedSurface& result, const SurfaceOptions& options, const std::string& said_by_file) {
  if (!options.axes.empty()) return Axes(options.axes);
  if (!said_by_file.empty()) {
    result.notes.push_back("axes " + said_by_file + ", as the file says");
    return Axes(said_by_file);
  }
  if (!options.axes_of_others.empty()) {
    result.notes.push_back("axes " + options.axes_of_others + ", as of the subject's other surface");
    return Axes(options.axes_of_others);
  }
  if (const auto guess = guess_axes(result.surface)) {
    result.notes.push_back("axes guessed as " + guess->axes.letters() + ": " + guess->reasons +
                           "; --axes says otherwise");
    return guess->axes;
  }
  result.notes.push_back(
      "axes taken as RAS (x right, y forward, z up): this surface's shape does not tell them; "
      "--axes says otherwise");
  return {};
}

void turn_into_trunk(ImportedSurface& result, const Axes& axes) {
  for (Vec3d& p : result.surface.points) p = axes(p);
  face_outward(result.surface);
  result.axes = axes.letters();
  if (axes.mirrors())
    result.notes.push_back("axes " + axes.letters() +
                           " are left-handed: the surface is mirrored on the way, check that this is meant");
}

void note_repairs(ImportedSurface& result) {
  const RepairReport& r = result.repaired;
  std::string repairs;
  const auto mention = [&](std::size_t count, const std::string& single, const std::string& several) {
    if (count > 0) repairs += (repairs.empty() ? "" : ", ") + counted(count, single, several);
  };
  mention(r.merged_points, "point merged", "points merged");
  mention(r.isolated_points, "point of no triangle dropped", "points of no triangle dropped");
  mention(r.degenerate, "degenerate triangle dropped", "degenerate triangles dropped");
  mention(r.duplicates, "triangle dropped that was there twice", "triangles dropped that were there twice");
  mention(r.slivers, "sliver kept", "slivers kept");
  mention(r.turned, "triangle turned over", "triangles turned over");
  mention(r.specks, "speck dropped", "specks dropped");
  if (!repairs.empty()) result.notes.push_back(repairs);
  if (r.two_sided())
    result.notes.push_back("two sheets " + number_text(1e3 * r.sheet_thickness, 3) + " mm apart on " +
                           number_text(100.0 * r.sheet_share, 3) + " % of the area: their middle is taken, " +
                           counted(r.sheet_triangles, "triangle", "triangles") + " dropped");
  if (r.branching_edges > 0)
    result.notes.push_back(counted(r.branching_edges, "edge", "edges") +
                           " of three or more triangles: inside and outside are uncertain there");
  if (!r.oriented)
    result.notes.push_back("the surface is one-sided somewhere: the sign of a distance is uncertain");
  result.notes.push_back(
      counted(result.surface.triangles.size(), "triangle", "triangles") + ", " +
      (r.closed() ? "closed" : "open, " + counted(r.borders, "border", "borders or holes")) + ", " +
      counted(r.pieces, "piece", "pieces"));
}

}  // namespace

ImportedSurface read_surface(const std::filesystem::path& path, const SurfaceOptions& options) {
  if (!options.axes.empty()) Axes checked(options.axes);  // before a large file is read
  const std::string file = path.string();
  RawSurface from = read_raw_surface(read_file(path, largest_surface_file), file);
  if (!options.component.empty()) keep_component(from, options.component, file);

  ImportedSurface result;
  result.format = from.format;
  result.surface = {path.filename().string(), std::move(from.points), std::move(from.triangles)};
  result.repaired = repair(result.surface);
  if (result.surface.triangles.empty())
    throw InputError(file, 0, "all triangles are degenerate; expected a surface; export it again");
  if (flatness(result.surface) < 1e-3)
    throw InputError(file, 0,
                     "all points lie in one plane or line; expected a surface in space; check the export");
  choose_unit(result, options, from.unit, file);
  turn_into_trunk(result, chosen_axes(result, options, from.axes));
  note_repairs(result);
  return result;
}

}  // namespace trunk
