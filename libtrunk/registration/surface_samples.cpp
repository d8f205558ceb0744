#include "registration/surface_samples.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

const Vec3d& corner(std::span<const Vec3d> points, const Triangle& t, std::size_t k) {
  return points[static_cast<std::size_t>(t[k])];
}

Vec3d twice_area_vector(std::span<const Vec3d> points, const Triangle& t) {
  return cross(corner(points, t, 1) - corner(points, t, 0), corner(points, t, 2) - corner(points, t, 0));
}

double longest_edge(std::span<const Vec3d> points, const Triangle& t) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, norm(corner(points, t, (k + 1) % 3) - corner(points, t, k)));
  return longest;
}

}  // namespace

Vec3d SurfaceSample::in(std::span<const Vec3d> points, std::span<const Triangle> triangles) const {
  const Triangle& t = triangles[static_cast<std::size_t>(triangle)];
  return weight[0] * corner(points, t, 0) + weight[1] * corner(points, t, 1) +
         weight[2] * corner(points, t, 2);
}

std::vector<SurfaceSample> surface_samples(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                                           double spacing) {
  constexpr double most_parts = 64.0;
  std::vector<SurfaceSample> samples;
  for (std::size_t index = 0; index < triangles.size(); ++index) {
    const Triangle& t = triangles[index];
    const int parts =
        static_cast<int>(std::clamp(std::ceil(longest_edge(points, t) / spacing), 1.0, most_parts));
    const double area = 0.5 * norm(twice_area_vector(points, t)) / (parts * parts);
    const auto add = [&](double u, double v) {
      samples.push_back({static_cast<int>(index), {1.0 - (u + v) / parts, u / parts, v / parts}, area});
    };
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j) {
        add(i + 1.0 / 3.0, j + 1.0 / 3.0);
        if (i + j + 1 < parts) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
      }
  }
  return samples;
}

double surface_area(std::span<const Vec3d> points, std::span<const Triangle> triangles) {
  double area = 0.0;
  for (const Triangle& t : triangles) area += 0.5 * norm(twice_area_vector(points, t));
  return area;
}

Vec3d unit_normal(std::span<const Vec3d> points, const Triangle& triangle) {
  const Vec3d area = twice_area_vector(points, triangle);
  const double size = norm(area);
  return size > 0.0 ? (1.0 / size) * area : Vec3d{};
}

}  // namespace trunk
