#include "registration/elastic_matching.hpp"

#include <algorithm>
#include <cmath>

#include "anatomy/trunk.hpp"
#include "forces/shape_memory.hpp"
#include "registration/measured_target.hpp"
#include "registration/mesh_quality.hpp"
#include "registration/surface_samples.hpp"
#include "surface/distances.hpp"

namespace trunk {
namespace {

// Stiffness of all that draws toward one target, in units of k_elasticity: only ratios count here.
constexpr double first_attraction = 1e3, last_attraction = 5e3;
constexpr double within_surface = 20.0, of_lung = 0.1;
constexpr int stiffening = 30, settling = 20;
constexpr double first_reach = 0.060, last_reach = 0.020;  // m, where a pair counts a quarter: outliers

/// From the first to the last value in equal ratios.
double stiffened(double first, double last, int iteration) {
  return first * std::pow(last / first, std::min(1.0, static_cast<double>(iteration) / stiffening));
}

/// The trunk's surfaces: first as they resist any change, then as they resist those within.
class Elasticity {
 public:
  explicit Elasticity(const TrunkMesh& mesh) {
    const std::vector<double> abdomen = healthy_tissue(mesh, {}).stiffness;
    const std::vector<double> lung(mesh.rest.size(), of_lung * mesh.fineness * mesh.fineness);
    for (const double factor : {1.0, within_surface}) {
      balance_.add(memory_of(mesh, mesh.abdomen, abdomen, factor));
      balance_.add(memory_of(mesh, mesh.lung, lung, factor));
    }
  }

  std::vector<Vec3d> relaxed(const std::vector<Vec3d>& position, std::span<const LinearActuator> actuators) {
    constexpr int steps = 3;
    balance_.forget_bending(2, position);
    balance_.forget_bending(3, position);
    return balance_.relaxed(position, actuators, steps);
  }

 private:
  static ShapeMemory memory_of(const TrunkMesh& mesh, const std::vector<Triangle>& triangles,
                               std::vector<double> stiffness, double factor) {
    for (double& k : stiffness) k *= factor;
    const std::vector<double> none(mesh.rest.size(), 0.0);
    const Surface surface("trunk", triangles, static_cast<int>(mesh.rest.size()));
    return make_shape_memory(surface, mesh.rest, stiffness, none, Reaction::variational);
  }

  ElasticBalance balance_;
};

/// One target and its part of the trunk.
class Attractor {
 public:
  Attractor(const Attraction& attraction, std::span<const Vec3d> rest)
      : attraction_(attraction), target_(*attraction.target), area_(surface_area(rest, attraction.part)) {
    constexpr double spacing = 0.012;
    constexpr std::size_t target_points = 2500;
    if (attraction.direction != Attraction::Direction::target_to_part)
      samples_ = surface_samples(rest, attraction.part, spacing);
    if (attraction.direction != Attraction::Direction::part_to_target)
      points_ = spread_points(*attraction.target, target_points);
  }

  double area() const { return area_; }

  void add_to(std::vector<LinearActuator>& actuators, std::span<const Vec3d> position, double stiffness,
              double reach) const {
    for (const SurfaceSample& sample : samples_) {
      const auto hit = target_.closest(sample.in(position, attraction_.part));
      if (!target_.on_border(hit) && faces(position, sample.triangle, normal_of(hit.triangle)))
        add(actuators, sample.triangle, sample.weight, hit.point,
            stiffness * sample.area / area_ * counted(hit.distance, reach));
    }
    if (points_.empty()) return;
    const ClosestPoints part(position, attraction_.part);
    const double share = stiffness / static_cast<double>(points_.size());
    for (const TargetPoint& point : points_) {
      const auto hit = part(point.place);
      if (faces(position, hit.triangle, point.normal))
        add(actuators, hit.triangle, hit.weight, point.place, share * counted(hit.distance, reach));
    }
  }

 private:
  struct TargetPoint {
    Vec3d place, normal;
  };

  /// Points evenly over the target, with the way it faces there.
  static std::vector<TargetPoint> spread_points(const MeasuredSurface& target, std::size_t count) {
    const ClosestPoints on(target.points, target.triangles);
    std::vector<TargetPoint> points;
    for (const Vec3d& p : spread_over(target.points, target.triangles, count))
      points.push_back(
          {p, unit_normal(target.points, target.triangles[static_cast<std::size_t>(on(p).triangle)])});
    return points;
  }

  /// The weight of Geman and McClure.
  static double counted(double distance, double reach) {
    const double scaled = distance / reach;
    return 1.0 / ((1.0 + scaled * scaled) * (1.0 + scaled * scaled));
  }

  const Triangle& triangle(int of_part) const { return attraction_.part[static_cast<std::size_t>(of_part)]; }

  Vec3d normal_of(int of_target) const {
    const MeasuredSurface& surface = target_.surface();
    return unit_normal(surface.points, surface.triangles[static_cast<std::size_t>(of_target)]);
  }

  bool faces(std::span<const Vec3d> position, int of_part, const Vec3d& normal) const {
    constexpr double alike = 0.5;  // within 60 degrees
    if (attraction_.facing == Attraction::Facing::any) return true;
    const double cosine = dot(unit_normal(position, triangle(of_part)), normal);
    return attraction_.facing == Attraction::Facing::alike ? cosine > alike : cosine < -alike;
  }

  void add(std::vector<LinearActuator>& actuators, int of_part, const std::array<double, 3>& weight,
           const Vec3d& target, double stiffness) const {
    actuators.push_back({triangle(of_part), weight, target, stiffness});
  }

  const Attraction& attraction_;
  MeasuredTarget target_;
  double area_;
  std::vector<SurfaceSample> samples_;
  std::vector<TargetPoint> points_;
};

/// Half of the ring on both sides of a particle of the costal insertion, m.
double ring_share(const TrunkMesh& mesh, std::size_t line) {
  const auto& lines = mesh.muscle_lines;
  const auto at = [&](std::size_t k) {
    return mesh.rest[static_cast<std::size_t>(lines[k % lines.size()].front())];
  };
  return 0.5 * norm(at(line + 1) - at(line + lines.size() - 1));
}

LinearActuator on_particle(int particle, const Vec3d& target, double stiffness) {
  return {{particle, particle, particle}, {1.0, 0.0, 0.0}, target, stiffness};
}

/// Each particle of the costal insertion is drawn to the line of insertion at the angle it had. `per_length`:
/// N/m2.
void add_insertion(const TrunkMesh& mesh, const InsertionLine& insertion, double per_length,
                   std::vector<LinearActuator>& actuators) {
  for (std::size_t k = 0; k < mesh.muscle_lines.size(); ++k) {
    const int particle = mesh.muscle_lines[k].front();
    if (const auto target = insertion.beside(mesh.rest[static_cast<std::size_t>(particle)]))
      actuators.push_back(on_particle(particle, *target, per_length * ring_share(mesh, k)));
  }
}

/// The point at an arc length from the beginning of a polyline; beyond its end straight on.
Vec3d along(std::span<const Vec3d> polyline, double length) {
  std::size_t k = 0;
  for (; k + 2 < polyline.size(); ++k) {
    const double piece = norm(polyline[k + 1] - polyline[k]);
    if (length <= piece) break;
    length -= piece;
  }
  const Vec3d direction = polyline[k + 1] - polyline[k];
  return polyline[k] + (length / norm(direction)) * direction;
}

/// The rows of the zone of apposition slide along the muscle lines until these have the length wanted.
void add_apposition_length(const TrunkMesh& mesh, double wanted, std::span<const Vec3d> position,
                           double per_length, std::vector<LinearActuator>& actuators) {
  const std::size_t top = mesh.apposition_top_row();
  std::vector<std::vector<Vec3d>> polylines;
  double mean = 0.0;
  for (const auto& line : mesh.muscle_lines) {
    polylines.emplace_back();
    for (int i : line) polylines.back().push_back(position[static_cast<std::size_t>(i)]);
    for (std::size_t row = 0; row < top; ++row)
      mean += norm(polylines.back()[row + 1] - polylines.back()[row]) /
              static_cast<double>(mesh.muscle_lines.size());
  }
  for (std::size_t k = 0; k < polylines.size(); ++k) {
    double length = 0.0;
    for (std::size_t row = 1; row <= top; ++row) {
      length += norm(polylines[k][row] - polylines[k][row - 1]);
      actuators.push_back(on_particle(mesh.muscle_lines[k][row], along(polylines[k], length * wanted / mean),
                                      per_length * ring_share(mesh, k)));
    }
  }
}

double mean_z(const TrunkMesh& mesh, std::span<const int> particles) {
  double sum = 0.0;
  for (int i : particles) sum += mesh.rest[static_cast<std::size_t>(i)].z();
  return sum / static_cast<double>(particles.size());
}

}  // namespace

void fit_insertion(const InsertionLine& line, TrunkMesh& mesh) {
  std::vector<int> border;
  for (const auto& muscle : mesh.muscle_lines) border.push_back(muscle.back());
  const double pelvis = mean_z(mesh, mesh.named("pelvis")),
               costal = mean_z(mesh, mesh.named("costal_insertion")),
               top = mean_z(mesh, mesh.named("apposition_top")), tendon = mean_z(mesh, border),
               lung_top = mean_z(mesh, mesh.named("lung_top"));
  const auto rise = [&](std::initializer_list<const char*> regions, auto&& share) {
    for (const char* region : regions)
      for (int i : mesh.named(region)) {
        Vec3d& p = mesh.rest[static_cast<std::size_t>(i)];
        p += Vec3d{0.0, 0.0, std::clamp(share(p.z()), 0.0, 1.0) * (line.height_beside(p) - costal)};
      }
  };
  const auto above = [&](double z) { return (tendon - z) / (tendon - costal); };
  rise({"abdominal_wall"}, [&](double z) { return (z - pelvis) / (costal - pelvis); });
  rise({"costal_insertion", "zone_of_apposition", "muscular_dome"}, above);
  rise({"lung_wall"}, [&](double z) { return above(top) * (lung_top - z) / (lung_top - top); });
}

Matching match(const TrunkMesh& placed, const MatchingGoals& goals,
               const std::function<void(int iteration, int of)>& progress) {
  constexpr double strip = 0.03;  // m of diaphragm that a line counts as
  constexpr int iterations = stiffening + settling;
  Elasticity elasticity(placed);
  std::vector<Attractor> attractors;
  double area = 0.0;
  for (const Attraction& a : goals.attractions) {
    attractors.emplace_back(a, placed.rest);
    area = std::max(area, attractors.back().area());
  }
  Matching matching{placed.rest, 0, 0.0, false};
  std::vector<Vec3d> sound = placed.rest;
  for (; matching.iterations < iterations; ++matching.iterations) {
    const int n = matching.iterations;
    progress(n, iterations);
    const double stiffness = stiffened(first_attraction, last_attraction, n);
    std::vector<LinearActuator> actuators = goals.landmarks;
    for (LinearActuator& landmark : actuators) landmark.stiffness *= stiffness;
    for (const Attractor& attractor : attractors)
      attractor.add_to(actuators, matching.position, stiffness, stiffened(first_reach, last_reach, n));
    if (goals.insertion) add_insertion(placed, *goals.insertion, stiffness * strip / area, actuators);
    if (goals.apposition_length)
      add_apposition_length(placed, *goals.apposition_length, matching.position, stiffness * strip / area,
                            actuators);
    std::vector<Vec3d> next = elasticity.relaxed(matching.position, actuators);
    matching.moved = 0.0;
    for (std::size_t i = 0; i < next.size(); ++i)
      matching.moved = std::max(matching.moved, norm(next[i] - matching.position[i]));
    matching.position = std::move(next);
    matching.stopped_early = !mesh_quality(placed, matching.position).sound();
    if (!matching.stopped_early) sound = matching.position;
  }
  if (matching.stopped_early) matching.position = std::move(sound);
  return matching;
}

}  // namespace trunk
