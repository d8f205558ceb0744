#include "surface/distances.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

/// Returns a quantile by linear interpolation between sorted numbers. sorted: [1 or more].
double quantile(const std::vector<double>& sorted, double fraction) {
  const double at = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

double fraction_part(double value) {
  return value - std::floor(value);
}

const Vec3d& corner(std::span<const Vec3d> points, const Triangle& triangle, std::size_t i) {
  return points[static_cast<std::size_t>(triangle[i])];
}

std::vector<double> areas_up_to(std::span<const Vec3d> points, std::span<const Triangle> triangles) {
  std::vector<double> areas;
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    const Vec3d& a = corner(points, t, 0);
    sum += 0.5 * norm(cross(corner(points, t, 1) - a, corner(points, t, 2) - a));
    areas.push_back(sum);
  }
  return areas;
}

}  // namespace

Distances statistics_of(std::vector<double> distances) {
  if (distances.empty()) return {};
  std::sort(distances.begin(), distances.end());
  double sum = 0.0, squares = 0.0;
  for (const double d : distances) {
    sum += d;
    squares += d * d;
  }
  const auto n = static_cast<double>(distances.size());
  return {sum / n, std::sqrt(squares / n), quantile(distances, 0.5), quantile(distances, 0.95),
          distances.back()};
}

std::vector<Vec3d> spread_over(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                               std::size_t count) {
  const std::vector<double> areas = areas_up_to(points, triangles);
  std::vector<Vec3d> spread;
  if (areas.empty() || !(areas.back() > 0.0)) return spread;
  constexpr double plastic = 1.32471795724474602596;  // x^3 = x + 1
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<double>(i);
    const double area = areas.back() * (n + 0.5) / static_cast<double>(count);
    while (at + 1 < areas.size() && areas[at] < area) ++at;
    double u = fraction_part(0.5 + n / plastic), v = fraction_part(0.5 + n / (plastic * plastic));
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const Triangle& t = triangles[at];
    spread.push_back((1.0 - u - v) * corner(points, t, 0) + u * corner(points, t, 1) +
                     v * corner(points, t, 2));
  }
  return spread;
}

Distances distances(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                    const ClosestPoints& to, std::size_t samples) {
  std::vector<double> all;
  for (const Vec3d& p : spread_over(points, triangles, samples)) all.push_back(to(p).distance);
  Distances result = statistics_of(std::move(all));
  std::vector<bool> seen(points.size());
  for (const Triangle& t : triangles)
    for (const int i : t) {
      const auto point = static_cast<std::size_t>(i);
      if (!seen[point]) result.hausdorff = std::max(result.hausdorff, to(points[point]).distance);
      seen[point] = true;
    }
  return result;
}

}  // namespace trunk
