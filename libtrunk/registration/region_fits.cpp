#include "registration/region_fits.hpp"

#include <algorithm>

#include "registration/measured_target.hpp"
#include "registration/surface_samples.hpp"

namespace trunk {
namespace {

constexpr double fit_spacing = 0.006;  // m, between samples
constexpr double alike_cosine = 0.5;   // cosine, as in the matching

/// What was measured at one point of the part.
struct Measured {
  int particle;  // the nearest corner
  double distance;
  bool with_data;
};

int nearest_corner(const Triangle& triangle, const std::array<double, 3>& weight) {
  return triangle[static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin())];
}

bool alike(Attraction::Facing wanted, double cosine) {
  if (wanted == Attraction::Facing::any) return true;
  return wanted == Attraction::Facing::alike ? cosine > alike_cosine : cosine < -alike_cosine;
}

std::vector<Measured> of_part(const TrunkMesh& mesh, const Attraction& a) {
  const MeasuredTarget target(*a.target);
  std::vector<Measured> found;
  for (const SurfaceSample& s : surface_samples(mesh.rest, a.part, fit_spacing)) {
    const Triangle& triangle = a.part[static_cast<std::size_t>(s.triangle)];
    const auto hit = target.closest(s.in(mesh.rest, a.part));
    const Vec3d normal =
        unit_normal(a.target->points, a.target->triangles[static_cast<std::size_t>(hit.triangle)]);
    const bool counts =
        !target.on_border(hit) && alike(a.facing, dot(unit_normal(mesh.rest, triangle), normal));
    found.push_back({nearest_corner(triangle, s.weight), hit.distance, counts});
  }
  return found;
}

std::vector<Measured> of_target(const TrunkMesh& mesh, const Attraction& a) {
  constexpr std::size_t points = 20000;
  const ClosestPoints part(mesh.rest, a.part), on(a.target->points, a.target->triangles);
  std::vector<Measured> found;
  for (const Vec3d& p : spread_over(a.target->points, a.target->triangles, points)) {
    const auto hit = part(p);
    const Triangle& triangle = a.part[static_cast<std::size_t>(hit.triangle)];
    bool counts = true;
    if (a.facing != Attraction::Facing::any)
      counts = alike(
          a.facing,
          dot(unit_normal(mesh.rest, triangle),
              unit_normal(a.target->points, a.target->triangles[static_cast<std::size_t>(on(p).triangle)])));
    found.push_back({nearest_corner(triangle, hit.weight), hit.distance, counts});
  }
  return found;
}

template <class Wanted>
std::optional<Distances> distances_of(std::span<const Measured> all, Wanted&& wanted) {
  std::vector<double> chosen;
  for (const Measured& m : all)
    if (wanted(m)) chosen.push_back(m.distance);
  if (chosen.empty()) return std::nullopt;
  return summary_of(std::move(chosen));
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
    const auto samples = std::count_if(part.begin(), part.end(), in_region);
    if (samples == 0) return;
    const auto shown = std::count_if(part.begin(), part.end(), with_data);
    RegionFit fit{a.target->name,
                  name,
                  {},
                  {},
                  distances_of(target, with_data),
                  static_cast<double>(shown) / static_cast<double>(samples)};
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
  for (const Attraction& a : attractions) {
    const MeasuredTarget target(*a.target);
    for (const SurfaceSample& s : surface_samples(mesh.rest, a.part, fit_spacing))
      if (!target.on_border(target.closest(s.in(mesh.rest, a.part))))
        shown[static_cast<std::size_t>(
            nearest_corner(a.part[static_cast<std::size_t>(s.triangle)], s.weight))] = true;
  }
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
