#include "registration/elastic_matching.hpp"

#include <algorithm>
#include <cmath>

#include "anatomy/trunk.hpp"
#include "forces/shape_memory.hpp"
#include "math/units.hpp"
#include "registration/line_goals.hpp"
#include "registration/mesh_quality.hpp"

namespace trunk {
namespace {

// The stiffness of all actuators of one target, in units of k_elasticity: only ratios count here.
constexpr double first_attraction = 100.0, last_attraction = 5e3;
constexpr double within_surface = 5.0, of_lung = 0.1;
constexpr int stiffening = 30, settling = 20;
constexpr double first_reach = 0.060, last_reach = 0.020;  // m, the distance at which a pair counts a quarter

/// Returns a value that goes from the first to the last in equal ratios.
double stiffened(double first, double last, int iteration) {
  return first * std::pow(last / first, std::min(1.0, static_cast<double>(iteration) / stiffening));
}

/// The elasticity of the trunk's surfaces: two memories that resist any change, and two that resist changes
/// within the surface.
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
    for (const std::size_t memory : within) balance_.forget_bending(memory, position);
    return balance_.relaxed(position, actuators, steps);
  }

  /// Makes the surfaces stiffer against changes within them, around these particles.
  void stiffen_within(const std::set<int>& particles) {
    constexpr double factor = 2.0;
    for (const std::size_t memory : within) balance_.stiffen(memory, particles, factor);
  }

 private:
  static constexpr std::size_t within[] = {2, 3};  // memories

  static ShapeMemory memory_of(const TrunkMesh& mesh, const std::vector<Triangle>& triangles,
                               std::vector<double> stiffness, double factor) {
    for (double& k : stiffness) k *= factor;
    const std::vector<double> none(mesh.rest.size(), 0.0);
    const Surface surface("trunk", triangles, static_cast<int>(mesh.rest.size()));
    return make_shape_memory(surface, mesh.rest, stiffness, none, Reaction::variational);
  }

  ElasticBalance balance_;
};

std::vector<Vec3d> between(std::span<const Vec3d> from, std::span<const Vec3d> to, double share) {
  std::vector<Vec3d> position;
  for (std::size_t i = 0; i < from.size(); ++i) position.push_back(from[i] + share * (to[i] - from[i]));
  return position;
}

/// Returns the share of the way on which no triangle folds or becomes too thin: 1, 1/2, 1/4, 1/8 or 0.
double sound_share(const TrunkMesh& placed, std::span<const Vec3d> from, std::span<const Vec3d> to) {
  constexpr double least = 0.1;
  double share = 1.0;
  while (share > least && !mesh_quality(placed, between(from, to, share)).sound()) share *= 0.5;
  return share > least ? share : 0.0;
}

double farthest(std::span<const Vec3d> from, std::span<const Vec3d> to) {
  double distance = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) distance = std::max(distance, norm(to[i] - from[i]));
  return distance;
}

}  // namespace

Matching match(const TrunkMesh& placed, const MatchingGoals& goals,
               const std::function<void(int iteration, int of)>& progress) {
  constexpr double strip = 0.03;  // m, the width of diaphragm for which a line counts
  constexpr double thin = 2.0 * rad_per_degree;
  constexpr int iterations = stiffening + settling;
  Elasticity elasticity(placed);
  std::vector<Attractor> attractors;
  double area = 0.0;
  for (const Attraction& a : goals.attractions) {
    attractors.emplace_back(a, placed.rest);
    area = std::max(area, attractors.back().area());
  }
  const auto drawn = [&](int n, std::span<const Vec3d> position) {
    const double stiffness = stiffened(first_attraction, last_attraction, n);
    std::vector<LinearActuator> actuators = goals.landmarks;
    for (LinearActuator& landmark : actuators) landmark.stiffness *= stiffness;
    for (const Attractor& attractor : attractors)
      attractor.add_to(actuators, position, stiffness, stiffened(first_reach, last_reach, n));
    const double line = stiffness * strip / area;
    if (goals.insertion) add_insertion(placed, *goals.insertion, position, line, actuators);
    if (goals.apposition_length)
      add_apposition_length(placed, *goals.apposition_length, position, goals.apposition_weight * line,
                            actuators);
    return actuators;
  };

  Matching matching{placed.rest, 0, 0.0, false};
  for (; matching.iterations < iterations; ++matching.iterations) {
    progress(matching.iterations, iterations);
    const std::vector<Vec3d> next =
        elasticity.relaxed(matching.position, drawn(matching.iterations, matching.position));
    elasticity.stiffen_within(particles_of_thinned_triangles(placed, matching.position, next, thin));
    const double share = sound_share(placed, matching.position, next);
    matching.held_back = share < 1.0;
    matching.moved = share * farthest(matching.position, next);
    matching.position = between(matching.position, next, share);
  }
  return matching;
}

}  // namespace trunk
