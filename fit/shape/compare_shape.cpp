#include "shape/compare_shape.hpp"

#include "surface/signed_distance.hpp"

namespace trunk {
namespace {

constexpr std::size_t samples = 20000;

/// Adds the distances of samples of the region. Its corners count only for the largest distance. => result
void compare_region(const RunRegion& region, const SignedDistance& to, ShapeComparison& result) {
  std::vector<double> all, covered;
  for (const Vec3d& p : spread_over(region.points, region.triangles, samples)) {
    const SignedDistance::Hit hit = to(p);
    all.push_back(hit.distance);
    if (!hit.at_border) covered.push_back(hit.distance);
    result.mean_side += hit.side / static_cast<double>(samples);
  }
  result.covered = static_cast<double>(covered.size()) / static_cast<double>(samples);
  result.to_surface = statistics_of(std::move(all));
  result.covered_to_surface = statistics_of(std::move(covered));
  for (const Vec3d& p : region.points) {
    const SignedDistance::Hit hit = to(p);
    result.side.push_back(hit.side);
    result.at_border.push_back(hit.at_border);
    result.to_surface.hausdorff = std::max(result.to_surface.hausdorff, hit.distance);
  }
}

}  // namespace

ShapeComparison compare_shape(const RunRegion& region, MeasuredSurface& surface, bool align) {
  ShapeComparison result;
  const ClosestPoints to_region(region.points, region.triangles);
  if (align) {
    result.moved = aligned(surface.points, surface.triangles, to_region,
                           middle_of_area(region.points, region.triangles));
    for (Vec3d& p : surface.points) p = result.moved(p);
  }
  compare_region(region, SignedDistance(surface.points, surface.triangles), result);
  result.from_surface = distances(surface.points, surface.triangles, to_region, samples);
  return result;
}

}  // namespace trunk
