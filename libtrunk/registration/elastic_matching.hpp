#pragma once

#include <functional>
#include <optional>

#include "anatomy/trunk_mesh.hpp"
#include "registration/attractor.hpp"
#include "registration/insertion_line.hpp"

namespace trunk {

/// What an elastic matching strives for. Pointers outlive it. z is up.
struct MatchingGoals {
  std::vector<Attraction> attractions;
  const InsertionLine* insertion = nullptr;  // of the costal insertion; none: left to shape memory
  std::vector<LinearActuator> landmarks;     // stiffness as a share of a surface's
  std::optional<double> apposition_length;   // m, mean along the muscle lines
  double apposition_weight = 1.0;            // a line that was measured has 1
};

struct Matching {
  std::vector<Vec3d> position;  // [particles] m
  int iterations = 0;
  double moved = 0.0;      // m, the farthest in the last iteration
  bool held_back = false;  // the last one: to keep triangles from folding
};

/// Deforms a trunk onto measured surfaces, by the simulator's own means. Linear actuators draw points of the
/// trunk to the closest points of the targets, and points of the targets draw what is closest of the trunk;
/// shape memory resists and carries along what nothing draws. Each iteration renews the closest points and
/// goes toward the balance of all forces; attraction stiffens from one to the next, so that the whole shape
/// is matched before its detail. Our choice beyond the paper's one sentence ("an elastic matching
/// algorithm"):
///  - shape memory within the surface 5 times as stiff as across it, since its own law hardly resists
///  slivers,
///    and again twice as stiff around each triangle that grows thinner below 2 degrees; an iteration that
///    would fold one goes half, a quarter or an eighth of its way, or none;
///  - the lung's surface elastic, too, a tenth as stiff, to carry its wall along.
/// `progress(iteration, of)` is called before each.
Matching match(const TrunkMesh& placed, const MatchingGoals& goals,
               const std::function<void(int iteration, int of)>& progress);

}  // namespace trunk
