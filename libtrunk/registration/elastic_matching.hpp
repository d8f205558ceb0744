#pragma once

#include <functional>
#include <optional>

#include "anatomy/trunk_mesh.hpp"
#include "registration/attractor.hpp"
#include "registration/insertion_line.hpp"

namespace trunk {

/// The goals of an elastic matching. Their pointers have to outlive it. z is up.
struct MatchingGoals {
  std::vector<Attraction> attractions;
  const InsertionLine* insertion = nullptr;  // of the costal insertion; none: shape memory decides
  std::vector<LinearActuator> landmarks;     // stiffness as a share of that of a surface
  std::optional<double> apposition_length;   // m, mean along the muscle lines
  double apposition_weight = 1.0;            // 1 for a measured length
};

/// The result of `match`.
struct Matching {
  std::vector<Vec3d> position;  // [particles] m
  int iterations = 0;
  double moved = 0.0;      // m, the farthest in the last iteration
  bool held_back = false;  // the last iteration was shortened, so that no triangle folds
};

/// Deforms a trunk onto measured surfaces with the simulator's own forces, and returns the new positions.
/// Linear actuators pull points of the trunk to the closest points of the targets, and the closest points of
/// the trunk to points of the targets. Shape memory resists, and it moves the particles on which no actuator
/// acts. Each iteration finds new closest points and goes toward the balance of all forces. Attraction
/// becomes stiffer from one iteration to the next, so that the whole shape is matched before its detail. The
/// paper has one sentence on this ("an elastic matching algorithm"); these are our choices:
///  - Shape memory within the surface is 5 times as stiff as across it, since its own law hardly resists
///    slivers. It becomes twice as stiff around each triangle that gets thinner and has an angle below 2
///    degrees.
///  - An iteration that would fold a triangle goes a half, a quarter or an eighth of its way, or none.
///  - The lung's surface is elastic, too, and a tenth as stiff, to move its wall along.
/// It calls `progress(iteration, of)` before each iteration.
Matching match(const TrunkMesh& placed, const MatchingGoals& goals,
               const std::function<void(int iteration, int of)>& progress);

}  // namespace trunk
