#pragma once

#include <functional>
#include <optional>

#include "anatomy/trunk_mesh.hpp"
#include "registration/insertion_line.hpp"
#include "registration/linear_actuators.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A measured surface that draws a part of the trunk.
struct Attraction {
  /// Which of the two has its place on the other: points of the part are drawn to the target, points of the
  /// target draw the part, or both.
  enum class Direction { both, part_to_target, target_to_part };
  /// Pairs count only where their surfaces face alike, or against each other.
  enum class Facing { any, alike, opposed };

  const MeasuredSurface* target;
  std::vector<Triangle> part;  // of the trunk
  Direction direction = Direction::both;
  Facing facing = Facing::any;
};

/// What an elastic matching strives for. Pointers outlive it. z is up.
struct MatchingGoals {
  std::vector<Attraction> attractions;
  const InsertionLine* insertion = nullptr;  // of the costal insertion; none: left to shape memory
  std::vector<LinearActuator> landmarks;     // stiffness as a share of a surface's
  std::optional<double> apposition_length;   // m, mean along the muscle lines
};

struct Matching {
  std::vector<Vec3d> position;  // [particles] m
  int iterations = 0;
  double moved = 0.0;          // m, the farthest in the last iteration
  bool stopped_early = false;  // where going on would have folded a triangle
};

/// Raises or lowers the costal insertion to the smooth curve of a measured one. What lies above follows in
/// proportion up to the border of the central tendon and along the lung's wall to its top, what lies below
/// down to the pelvis. z is up.
void fit_insertion(const InsertionLine& line, TrunkMesh& mesh);

/// Deforms a trunk onto measured surfaces, by the simulator's own means. Linear actuators draw points of the
/// trunk to the closest points of the targets, and points of the targets draw what is closest of the trunk;
/// shape memory resists and carries along what nothing draws. Each iteration renews the closest points and
/// goes toward the balance of all forces; attraction stiffens from one to the next, so that the whole shape
/// is matched before its detail. Where the closest point lies on the border of an open target the data end,
/// and nothing is drawn. Our choice beyond the paper's one sentence ("an elastic matching algorithm"):
///  - shape memory within the surface 20 times as stiff as across it: its own law hardly resists slivers;
///  - the lung's surface elastic, too, a tenth as stiff, to carry its wall along.
/// `progress(iteration, of)` is called before each.
Matching match(const TrunkMesh& placed, const MatchingGoals& goals,
               const std::function<void(int iteration, int of)>& progress);

}  // namespace trunk
