#include "surface/merge_points.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace trunk {
namespace {

/// Points sorted into cubes with edges of eight tolerances. A point that is near is in the same cube or
/// behind a face that is near.
class NearPoints {
 public:
  /// Cubes are counted from `origin`, one of the points, since their numbers would overflow far from 0.
  NearPoints(double tolerance, const Vec3d& origin) : tolerance_(tolerance), origin_(origin) {}

  /// Returns an earlier point within the tolerance; -1 if there is none, and then keeps this point as
  /// `index`.
  int find_or_add(const std::vector<Vec3d>& points, int index) {
    const Vec3d& p = points[static_cast<std::size_t>(index)];
    const double edge = 8.0 * tolerance_;
    std::array<std::array<std::int64_t, 2>, 3> cells;
    const Vec3d from = p - origin_;
    const std::array<double, 3> x{from.x() / edge, from.y() / edge, from.z() / edge};
    for (std::size_t i = 0; i < 3; ++i) {
      const double cell = std::floor(x[i]), within = x[i] - cell;
      cells[i][0] = static_cast<std::int64_t>(cell);
      cells[i][1] = cells[i][0] + (within < 0.125 ? -1 : within > 0.875 ? 1 : 0);
    }
    for (std::size_t corner = 0; corner < 8; ++corner) {
      bool repeated = false;
      std::array<std::int64_t, 3> cell;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t which = corner >> i & 1;
        repeated = repeated || (which == 1 && cells[i][1] == cells[i][0]);
        cell[i] = cells[i][which];
      }
      if (repeated) continue;
      const auto [begin, end] = cells_.equal_range(key(cell));
      for (auto known = begin; known != end; ++known)
        if (norm(points[static_cast<std::size_t>(known->second)] - p) <= tolerance_) return known->second;
    }
    cells_.emplace(key({cells[0][0], cells[1][0], cells[2][0]}), index);
    return -1;
  }

 private:
  static std::uint64_t key(const std::array<std::int64_t, 3>& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t i : cell) hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15u;
    return hash;
  }

  double tolerance_;
  Vec3d origin_;
  std::unordered_multimap<std::uint64_t, int> cells_;
};

}  // namespace

std::size_t merge_points(MeasuredSurface& s, double tolerance) {
  if (s.points.empty() || !(tolerance > 0.0)) return 0;
  NearPoints near(tolerance, s.points.front());
  std::size_t merged = 0;
  std::vector<int> same(s.points.size());
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const int index = static_cast<int>(i), earlier = near.find_or_add(s.points, index);
    same[i] = earlier < 0 ? index : earlier;
    merged += earlier >= 0;
  }
  for (Triangle& t : s.triangles)
    for (int& corner : t) corner = same[static_cast<std::size_t>(corner)];
  return merged;
}

}  // namespace trunk
