#include "registration/region_fits.hpp"

#include <algorithm>

#include "registration/surface_samples.hpp"
#include "registration/target_surface.hpp"

namespace trunk {
namespace {

constexpr std::size_t points_on_each = 20000;  // evenly over the area

/// The distance at one point.
struct Measured {
  int particle;  // the nearest corner of the part
  double distance;
  bool with_data;
};

int nearest_corner(const Triangle& triangle, const std::array<double, 3>& weight) {
  return triangle[static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin())];
}

std::vector<Measured> of_part(const TrunkMesh& mesh, const Attraction& a) {
  const std::size_t count = std::max<std::size_t>(points_on_each, 20 * a.part.size());
  const TargetSurface target(*a.target);
  const std::vector<Vec3d> points = spread_over(mesh.rest, a.part, count);
  const auto on_part = ClosestPoints(mesh.rest, a.part)(points), on_target = target.closest(points);
  std::vector<Measured> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Triangle& triangle = a.part[static_cast<std::size_t>(on_part[i].triangle)];
    const Vec3d normal = unit_normal(mesh.rest, triangle);
    found.push_back({nearest_corner(triangle, on_part[i].weight), on_target[i].distance,
                     !target.ends_before(points[i], normal, on_target[i]) &&
                         a.faces(normal, target.normal(on_target[i]))});
  }
  return found;
}

std::vector<Measured> of_target(const TrunkMesh& mesh, const Attraction& a) {
  const TargetSurface target(*a.target);
  const std::vector<Vec3d> points = spread_over(a.target->points, a.target->triangles, points_on_each);
  const auto on_part = ClosestPoints(mesh.rest, a.part)(points), on_target = target.closest(points);
  std::vector<Measured> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Triangle& triangle = a.part[static_cast<std::size_t>(on_part[i].triangle)];
    found.push_back({nearest_corner(triangle, on_part[i].weight), on_part[i].distance,
                     a.faces(unit_normal(mesh.rest, triangle), target.normal(on_target[i]))});
  }
  return found;
}

template <class Wanted>
std::optional<Distances> distances_of(std::span<const Measured> all, Wanted&& wanted) {
  std::vector<double> chosen;
  for (const Measured& m : all)
    if (wanted(m)) chosen.push_back(m.distance);
  if (chosen.empty()) return std::nullopt;
  return statistics_of(std::move(chosen));
}

}  // namespace

void add_region_fits(const TrunkMesh& mesh, const Attraction& a, std::vector<RegionFit>& fits) {
  using Direction = Attraction::Direction;
  const bool to_part = a.direction != Direction::part_to_target,
             to_target = a.direction != Direction::target_to_part;
  const std::vector<Measured> part = of_part(mesh, a),
                              target = to_part ? of_target(mesh, a) : std::vector<Measured>();
  const auto add = [&](const std::string& name, auto&& belongs) {
    const auto in_region = [&](const Measured& m) { return belongs(m.particle); };
    const auto with_data = [&](const Measured& m) { return m.with_data && belongs(m.particle); };
    const auto points = std::count_if(part.begin(), part.end(), in_region);
    if (points == 0) return;
    const auto shown = std::count_if(part.begin(), part.end(), with_data);
    RegionFit fit{a.target->name,
                  name,
                  {},
                  {},
                  distances_of(target, with_data),
                  static_cast<double>(shown) / static_cast<double>(points)};
    if (to_target) {
      fit.to_target = distances_of(part, with_data);
      fit.to_target_all = distances_of(part, in_region);
    }
    fits.push_back(std::move(fit));
  };
  add("all", [](int) { return true; });
  for (const auto& [name, particles] : mesh.regions) {
    std::vector<bool> inside(mesh.rest.size());
    for (int i : particles) inside[static_cast<std::size_t>(i)] = true;
    add(name, [&](int i) { return inside[static_cast<std::size_t>(i)]; });
  }
}

std::vector<std::string> regions_without_data(const TrunkMesh& mesh, std::span<const Attraction> attractions,
                                              std::size_t& particles) {
  std::vector<bool> shown(mesh.rest.size());
  for (const Attraction& a : attractions)
    for (const Measured& m : of_part(mesh, a))
      if (m.with_data) shown[static_cast<std::size_t>(m.particle)] = true;
  particles = static_cast<std::size_t>(std::count(shown.begin(), shown.end(), false));
  std::vector<std::string> regions;
  for (const auto& [name, its] : mesh.regions) {
    const auto with_data =
        std::count_if(its.begin(), its.end(), [&](int i) { return shown[static_cast<std::size_t>(i)]; });
    if (2 * with_data < static_cast<std::ptrdiff_t>(its.size())) regions.push_back(name);
  }
  return regions;
}

}  // namespace trunk
