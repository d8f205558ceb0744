#include "registration/alignment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "math/units.hpp"
#include "registration/surface_samples.hpp"
#include "registration/target_surface.hpp"
#include "surface/closest_points.hpp"
#include "surface/distances.hpp"

namespace trunk {
namespace {

constexpr double kept_part = 0.8;

/// Corresponding points, [pairs] each.
struct Matches {
  std::vector<Vec3d> of_trunk, measured;
  std::vector<Vec3d> normal;     // of the trunk, since a measured surface is noisy; zero: any direction
  std::vector<double> distance;  // m, as measured
};

/// One part of the trunk and its measured surface, with points spread over each and their closest points.
class Corresponding {
 public:
  Corresponding(const SurfacePair& pair, std::size_t samples)
      : pair_(pair),
        trunk_points_(spread_over(pair.particles, pair.triangles, samples)),
        measured_points_(spread_over(pair.target->points, pair.target->triangles, samples)),
        trunk_(pair.particles, pair.triangles),
        measured_(*pair.target) {
    for (const auto& hit : trunk_(trunk_points_)) trunk_normals_.push_back(normal(hit));
  }

  const std::vector<Vec3d>& trunk_points() const { return trunk_points_; }
  const std::vector<Vec3d>& measured_points() const { return measured_points_; }

  /// Adds the pairs of closest points. With `inside`, points beyond the border of an open surface are left
  /// out, since they have no counterpart; the start has to be near for this. => matches
  void add_matches(const Similarity& at, bool inside, Matches& matches) const {
    Matches to_measured, to_trunk;
    std::vector<Vec3d> placed, taken_back;
    for (const Vec3d& x : trunk_points_) placed.push_back(at(x));
    for (const Vec3d& q : measured_points_) taken_back.push_back(at.inverse(q));
    const auto on_measured = measured_.closest(placed), on_trunk = trunk_(taken_back);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const auto& hit = on_measured[i];
      const Vec3d facing = turn(at.rotation, trunk_normals_[i]);
      if (!inside || !measured_.ends_before(placed[i], facing, hit))
        add(trunk_points_[i], hit.point, facing, hit.distance, to_measured);
    }
    for (std::size_t i = 0; i < taken_back.size(); ++i) {
      const auto& hit = on_trunk[i];
      add(hit.point, measured_points_[i], turn(at.rotation, normal(hit)), at.scale * hit.distance, to_trunk);
    }
    for (const Matches* direction : {&to_measured, &to_trunk}) keep_closest(*direction, matches);
  }

 private:
  Vec3d normal(const ClosestPoints::Hit& hit) const {
    return unit_normal(pair_.particles, pair_.triangles[static_cast<std::size_t>(hit.triangle)]);
  }

  static void add(const Vec3d& of_trunk, const Vec3d& measured, const Vec3d& normal, double distance,
                  Matches& to) {
    to.of_trunk.push_back(of_trunk);
    to.measured.push_back(measured);
    to.normal.push_back(normal);
    to.distance.push_back(distance);
  }

  static void keep_closest(const Matches& from, Matches& to) {
    if (from.distance.empty()) return;
    std::vector<double> sorted = from.distance;
    const auto last =
        sorted.begin() + static_cast<std::ptrdiff_t>(kept_part * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), last, sorted.end());
    for (std::size_t i = 0; i < from.distance.size(); ++i)
      if (from.distance[i] <= *last)
        add(from.of_trunk[i], from.measured[i], from.normal[i], from.distance[i], to);
  }

  SurfacePair pair_;
  std::vector<Vec3d> trunk_points_, trunk_normals_, measured_points_;
  ClosestPoints trunk_;
  TargetSurface measured_;
};

Vec3d mean(std::span<const Vec3d> points) {
  Vec3d sum;
  for (const Vec3d& p : points) sum += p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

double spread(std::span<const Vec3d> points, const Vec3d& centre) {
  double sum = 0.0;
  for (const Vec3d& p : points) sum += dot(p - centre, p - centre);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// Returns the similarity that gives the rotated trunk the centre and the spread of the measured points.
Similarity start_from(std::span<const Corresponding> sides, const Rotation<double>& rotation) {
  std::vector<Vec3d> trunk, measured;
  for (const Corresponding& side : sides) {
    trunk.insert(trunk.end(), side.trunk_points().begin(), side.trunk_points().end());
    measured.insert(measured.end(), side.measured_points().begin(), side.measured_points().end());
  }
  const Vec3d from = mean(trunk), to = mean(measured);
  Similarity start{spread(measured, to) / spread(trunk, from), rotation, {}};
  start.shift = to - start(from);
  return start;
}

/// Returns the axis of a rotation, as long as its angle, rad.
Vec3d rotation_vector(const Rotation<double>& rotation) {
  const double sine = norm(rotation.v), angle = 2.0 * std::atan2(sine, std::abs(rotation.w));
  return sine > 0.0 ? (rotation.w < 0.0 ? -1.0 : 1.0) * angle / sine * rotation.v : Vec3d();
}

/// Returns the similarity after one Gauss-Newton step in rotation, shift and scale that brings the matches
/// together. Surfaces are free to slide along each other, which takes far fewer iterations near the end (Chen
/// and Medioni 1992).
/// A turn by an angle costs `uprightness` times the squares of the movements that it makes.
Similarity sliding(const Similarity& at, const Matches& matches, double uprightness) {
  using Row = Eigen::Matrix<double, 7, 1>;
  Vec3d centre;
  for (const Vec3d& q : matches.measured) centre += (1.0 / static_cast<double>(matches.measured.size())) * q;
  Eigen::Matrix<double, 7, 7> normal = Eigen::Matrix<double, 7, 7>::Zero();
  Row right = Row::Zero();
  const auto add = [&](const Vec3d& arm, const Vec3d& n, const Vec3d& off) {
    const Vec3d moment = cross(arm, n);
    Row row;
    row << moment.x(), moment.y(), moment.z(), n.x(), n.y(), n.z(), dot(arm, n);
    normal += row * row.transpose();
    right += dot(n, off) * row;
  };
  for (std::size_t i = 0; i < matches.of_trunk.size(); ++i) {
    const Vec3d x = at(matches.of_trunk[i]), off = matches.measured[i] - x, n = matches.normal[i];
    if (dot(n, n) > 0.0)
      add(x - centre, n, off);
    else
      for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) add(x - centre, axis, off);
  }
  if (uprightness > 0.0) {
    double arms = 0.0;
    for (const Vec3d& q : matches.measured) arms += dot(q - centre, q - centre);
    const Vec3d turned = rotation_vector(at.rotation);
    const double weight = uprightness * arms;
    for (int k = 0; k < 3; ++k) normal(k, k) += weight;
    right[0] -= weight * turned.x();
    right[1] -= weight * turned.y();
    right[2] -= weight * turned.z();
  }
  normal.diagonal() *= 1.0 + 1e-6;
  const Row step = normal.ldlt().solve(right);
  const Rotation<double> turned = small_rotation(Vec3d{step[0], step[1], step[2]});
  const double grown = 1.0 + std::clamp(step[6], -0.2, 0.2);
  return {at.scale * grown, then(at.rotation, turned),
          centre + grown * turn(turned, at.shift - centre) + Vec3d{step[3], step[4], step[5]}};
}

/// How to iterate: whether the surfaces slide along each other, and what a turn costs. With `uprightness` > 0
/// points beyond the border of an open surface never count.
struct Manner {
  bool slide = false;
  double uprightness = 0.0;
};

Alignment iterate(std::span<const Corresponding> surfaces, std::span<const NamedPoint> landmarks,
                  Alignment at, int iterations, const Manner& manner) {
  const auto [slide, uprightness] = manner;
  constexpr double arrived_m = 1e-5, landmark_share = 0.2;
  for (int last = at.iterations + iterations; at.iterations < last; ++at.iterations) {
    Matches matches;
    for (const Corresponding& surface : surfaces)
      surface.add_matches(at.similarity, slide || uprightness > 0.0, matches);
    if (!slide) std::fill(matches.normal.begin(), matches.normal.end(), Vec3d());
    double squares = 0.0;
    for (const double d : matches.distance) squares += d * d;
    at.rms = std::sqrt(squares / static_cast<double>(matches.distance.size()));
    // All landmarks together have a fifth of the weight of the surfaces.
    const auto copies =
        landmarks.empty()
            ? 0
            : 1 + static_cast<std::size_t>(landmark_share * static_cast<double>(matches.distance.size()) /
                                           static_cast<double>(landmarks.size()));
    for (const NamedPoint& landmark : landmarks)
      for (std::size_t i = 0; i < copies; ++i) {
        matches.of_trunk.push_back(landmark.of_trunk);
        matches.measured.push_back(landmark.measured);
        matches.normal.push_back({});
      }
    const Similarity next = slide || uprightness > 0.0
                                ? sliding(at.similarity, matches, uprightness)
                                : fitted_similarity(matches.of_trunk, matches.measured);
    double moved = 0.0;
    for (const Vec3d& x : matches.of_trunk) moved = std::max(moved, norm(next(x) - at.similarity(x)));
    at.similarity = next;
    if (moved < arrived_m) break;
  }
  return at;
}

std::vector<Rotation<double>> starting_rotations() {
  constexpr double turn = 25.0 * rad_per_degree;
  std::vector<Rotation<double>> rotations;
  for (const double x : {0.0, turn, -turn})
    for (const double y : {0.0, turn, -turn})
      for (const double z : {0.0, turn, -turn})
        rotations.push_back(then(then(rotation_about({1, 0, 0}, x), rotation_about({0, 1, 0}, y)),
                                 rotation_about({0, 0, 1}, z)));
  return rotations;
}

std::vector<Corresponding> sides_of(std::span<const SurfacePair> pairs, std::size_t samples) {
  std::vector<Corresponding> sides;
  for (const SurfacePair& pair : pairs) sides.emplace_back(pair, samples);
  return sides;
}

}  // namespace

Alignment align(std::span<const SurfacePair> pairs, std::span<const NamedPoint> landmarks) {
  constexpr std::size_t few = 120, many = 500, best = 3;
  const std::vector<Corresponding> coarse = sides_of(pairs, few), fine = sides_of(pairs, many);
  std::vector<Alignment> found;
  for (const Rotation<double>& rotation : starting_rotations())
    found.push_back(iterate(coarse, landmarks, {start_from(coarse, rotation), 0.0, 0}, 10, {}));
  const auto better = [](const Alignment& a, const Alignment& b) { return a.rms < b.rms; };
  std::stable_sort(found.begin(), found.end(), better);
  found.resize(best);
  for (Alignment& a : found)
    a = iterate(fine, landmarks, iterate(fine, landmarks, a, 10, {}), 30, {.slide = true});
  return *std::min_element(found.begin(), found.end(), better);
}

Alignment align_upright(std::span<const SurfacePair> pairs, std::span<const NamedPoint> landmarks) {
  constexpr std::size_t samples = 500;
  constexpr double uprightness = 0.1;
  const std::vector<Corresponding> sides = sides_of(pairs, samples);
  Alignment at{start_from(sides, {}), 0.0, 0};
  at = iterate(sides, landmarks, at, 20, {.slide = false, .uprightness = uprightness});
  return iterate(sides, landmarks, at, 30, {.slide = true, .uprightness = uprightness});
}

}  // namespace trunk
