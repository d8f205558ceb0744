#include "report/surface_contents.hpp"

#include <cmath>

#include "math/units.hpp"
#include "surface/thinned.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_shown = 12000;

Packed::Json distance_row(const char* name, const Distances& d) {
  return {{"name", name},
          {"mean_mm", mm_per_m * d.mean},
          {"rms_mm", mm_per_m * d.rms},
          {"median_mm", mm_per_m * d.median},
          {"percentile95_mm", mm_per_m * d.percentile95},
          {"hausdorff_mm", mm_per_m * d.hausdorff}};
}

}  // namespace

Packed::Json surface_contents(const ComparedSurface& compared, Packed& packed) {
  const MeasuredSurface shown = thinned(compared.surface, most_shown);
  std::vector<double> points_mm, side_mm(compared.region.particles_of_run, std::nan(""));
  for (const Vec3d& p : shown.points)
    points_mm.insert(points_mm.end(), {mm_per_m * p.x(), mm_per_m * p.y(), mm_per_m * p.z()});
  std::vector<std::int32_t> corners;
  for (const Triangle& t : shown.triangles) corners.insert(corners.end(), t.begin(), t.end());
  for (std::size_t i = 0; i < compared.region.particles.size(); ++i)
    if (!compared.comparison.at_border[i])
      side_mm.at(static_cast<std::size_t>(compared.region.particles[i])) =
          mm_per_m * compared.comparison.side[i];
  return {{"name", compared.surface.name},
          {"region", compared.region.name},
          {"time_s", compared.region.time_s},
          {"triangles", compared.surface.triangles.size()},
          {"points_mm", packed.add_single(points_mm)},
          {"corners", packed.add(corners)},
          {"side_mm", packed.add_single(side_mm)},
          {"covered_percent", 100.0 * compared.comparison.covered},
          {"distances",
           {distance_row("model to surface", compared.comparison.to_surface),
            distance_row("the part of it that is over the surface", compared.comparison.covered_to_surface),
            distance_row("surface to model", compared.comparison.from_surface)}}};
}

}  // namespace trunk
