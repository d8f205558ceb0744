#include "surfaces/read_surface.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "math/units.hpp"
#include "surface/axes.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

std::string counted(std::size_t count, const std::string& single, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? single : several);
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
    throw InputError({file}, fmt::format("there is no component {} with triangles", excerpt(name)),
                     fmt::format("one of{}", names));
  }
  from.triangles = std::move(kept);
}

struct LengthUnit {
  std::string name;
  double metres;
};

LengthUnit named_unit(const std::string& name, const std::string& file) {
  for (const LengthUnit& unit : {LengthUnit{"mm", m_per_mm}, LengthUnit{"cm", 1e-2}, LengthUnit{"m", 1.0}})
    if (unit.name == name) return unit;
  throw InputError({file}, fmt::format("unit {} found", excerpt(name)), "mm, cm or m",
                   "correct --surface-unit");
}

/// Guesses the unit from the largest extent: m up to 1, cm from 5 to 100, mm from 100 to 1000. Our choice:
/// parts that move in breathing are at least 10 cm long.
LengthUnit guessed_unit(double extent, const std::string& file) {
  if (extent >= 0.05 && extent <= 1.0) return {"m", 1.0};
  if (extent >= 5.0 && extent < 100.0) return {"cm", 1e-2};
  if (extent >= 100.0 && extent <= 1000.0) return {"mm", m_per_mm};
  throw InputError({file}, fmt::format("the surface is {} units long", number_text(extent)),
                   "0.05 to 1 m, the size of a part of a human trunk, in m, cm or mm",
                   "scale it or give --surface-unit");
}

void choose_unit(ImportedSurface& result, const SurfaceOptions& options, const std::string& of_file,
                 const std::string& file) {
  const double extent = largest_extent(result.surface);
  const std::string& declared = options.unit.empty() ? of_file : options.unit;
  const LengthUnit unit = declared.empty() ? guessed_unit(extent, file) : named_unit(declared, file);
  if (const double size = extent * unit.metres; !(size >= 0.03 && size <= 2.0))
    throw InputError({file}, fmt::format("the surface is {} m long in {}", number_text(size), unit.name),
                     "0.05 to 1 m, the size of a part of a human trunk", "check the unit");
  result.unit = unit.name;
  result.repaired.sheet_thickness *= unit.metres;
  result.repaired.island_distance *= unit.metres;
  for (Vec3d& p : result.surface.points) p = unit.metres * p;
  if (!options.unit.empty()) return;
  result.notes.push_back(
      of_file.empty()
          ? fmt::format("unit taken as {}, since the surface is {} long; --surface-unit overrides this",
                        unit.name, number_text(extent))
          : fmt::format("unit {}, as the file says", unit.name));
}

Axes axes_of_file(const std::string& letters, const std::string& file) {
  try {
    return Axes(letters);
  } catch (const InputError& error) {
    rethrow_at({file}, error);
  }
}

Axes chosen_axes(ImportedSurface& result, const SurfaceOptions& options, const std::string& of_file,
                 const std::string& file) {
  if (!options.axes.empty()) return Axes(options.axes);
  if (!of_file.empty()) {
    result.notes.push_back(fmt::format("axes {}, as the file says", of_file));
    return axes_of_file(of_file, file);
  }
  if (!options.axes_of_others.empty()) {
    result.notes.push_back(
        fmt::format("axes {}, as for the subject's other surface", options.axes_of_others));
    return Axes(options.axes_of_others);
  }
  if (const auto guess = guess_axes(result.surface)) {
    result.axes_guessed = true;
    result.notes.insert(
        result.notes.begin(),
        fmt::format("axes guessed as {}, since the file does not say them: {}; --axes overrides "
                    "this",
                    guess->axes.letters(), guess->reasons));
    return guess->axes;
  }
  result.axes_assumed = true;
  result.notes.insert(result.notes.begin(),
                      "axes assumed to be RAS (x right, y forward, z up), since neither the file nor the "
                      "shape of this surface "
                      "says them; if they are others, left and right or front and back are exchanged; 3D "
                      "Slicer and DICOM have "
                      "LPS: then give --axes LPS");
  return {};
}

void turn_into_trunk(ImportedSurface& result, const Axes& axes) {
  for (Vec3d& p : result.surface.points) p = axes(p);
  face_outward(result.surface);
  result.axes = axes.letters();
  if (axes.mirrors())
    result.notes.push_back(fmt::format(
        "axes {} are left-handed, so the surface is mirrored: check that this is meant", axes.letters()));
}

void note_repairs(ImportedSurface& result) {
  const RepairReport& r = result.repaired;
  std::string repairs;
  const auto mention = [&](std::size_t count, const std::string& single, const std::string& several) {
    if (count > 0) repairs += (repairs.empty() ? "" : ", ") + counted(count, single, several);
  };
  mention(r.merged_points, "point merged", "points merged");
  mention(r.isolated_points, "point without a triangle dropped", "points without a triangle dropped");
  mention(r.degenerate, "degenerate triangle dropped", "degenerate triangles dropped");
  mention(r.duplicates, "duplicate triangle dropped", "duplicate triangles dropped");
  mention(r.slivers, "sliver kept", "slivers kept");
  mention(r.turned, "triangle turned over", "triangles turned over");
  mention(r.specks, "speck dropped", "specks dropped");
  if (!repairs.empty()) result.notes.push_back(repairs);
  if (r.islands > 0)
    result.notes.push_back(fmt::format("{} left out: small, and {} mm or more away from the rest",
                                       counted(r.islands, "piece", "pieces"),
                                       number_text(mm_per_m * r.island_distance, 3)));
  if (r.two_sided())
    result.notes.push_back(fmt::format(
        "two sheets {} mm apart on {} % of the area: the middle between them is used, {} dropped",
        number_text(mm_per_m * r.sheet_thickness, 3), number_text(percent_per_one * r.sheet_share, 3),
        counted(r.sheet_triangles, "triangle", "triangles")));
  if (r.branching_edges > 0)
    result.notes.push_back(
        fmt::format("{} with three or more triangles: inside and outside are uncertain there",
                    counted(r.branching_edges, "edge", "edges")));
  if (!r.oriented)
    result.notes.push_back("the surface is one-sided somewhere: the sign of a distance is uncertain");
  const std::string border =
      r.borders == 0 ? "closed" : fmt::format("open, {}", counted(r.borders, "border", "borders or holes"));
  result.notes.push_back(fmt::format("{}, {}, {}",
                                     counted(result.surface.triangles.size(), "triangle", "triangles"),
                                     border, counted(r.pieces, "piece", "pieces")));
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
    throw InputError({file}, "all triangles are degenerate", "a surface", "export it again");
  if (flatness(result.surface) < 1e-3)
    throw InputError({file}, "all points lie in one plane or line", "a surface in space", "check the export");
  choose_unit(result, options, from.unit, file);
  turn_into_trunk(result, chosen_axes(result, options, from.axes, file));
  note_repairs(result);
  return result;
}

}  // namespace trunk
