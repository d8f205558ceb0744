#include "report/surface_contents.hpp"

#include <cmath>

#include "surface/thinned.hpp"

namespace trunk {
namespace {

constexpr double mm = 1e3;
constexpr std::size_t most_shown = 12000;

Packed::Json distance_row(const char* name, const Distances& d) {
  return {{"name", name},
          {"mean_mm", mm * d.mean},
          {"rms_mm", mm * d.rms},
          {"median_mm", mm * d.median},
          {"percentile95_mm", mm * d.percentile95},
          {"hausdorff_mm", mm * d.hausdorff}};
}

}  // namespace

Packed::Json surface_contents(const ComparedSurface& beside, std::size_t particles, Packed& packed) {
  const MeasuredSurface shown = thinned(beside.surface, most_shown);
  std::vector<double> points_mm, side_mm(particles, std::nan(""));
  for (const Vec3d& p : shown.points) points_mm.insert(points_mm.end(), {mm * p.x(), mm * p.y(), mm * p.z()});
  std::vector<std::int32_t> corners;
  for (const Triangle& t : shown.triangles) corners.insert(corners.end(), t.begin(), t.end());
  for (std::size_t i = 0; i < beside.region.particles.size(); ++i)
    if (!beside.comparison.at_border[i])
      side_mm.at(static_cast<std::size_t>(beside.region.particles[i])) = mm * beside.comparison.side[i];
  return {{"name", beside.surface.name},
          {"region", beside.region.name},
          {"time_s", beside.region.time_s},
          {"triangles", beside.surface.triangles.size()},
          {"points_mm", packed.add_single(points_mm)},
          {"corners", packed.add(corners)},
          {"side_mm", packed.add_single(side_mm)},
          {"covered_percent", 100.0 * beside.comparison.covered},
          {"distances",
           {distance_row("model to surface", beside.comparison.to_surface),
            distance_row("the part of it that is over the surface", beside.comparison.covered_to_surface),
            distance_row("surface to model", beside.comparison.from_surface)}}};
}

}  // namespace trunk
