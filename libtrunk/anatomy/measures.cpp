#include "anatomy/measures.hpp"

#include <algorithm>

#include "mesh/volume.hpp"

namespace trunk {
namespace {

template <class Select>
double mean_height(const Level& level, std::span<const Vec3d> position, Select select) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < level.particles.size(); ++k)
    if (select(k)) {
      sum += position[static_cast<std::size_t>(level.particles[k])].z();
      ++count;
    }
  return sum / count;
}

double mean_line_length(const TemplateMesh& mesh, std::span<const Vec3d> position) {
  const Level* line[] = {&mesh.costal_insertion, &mesh.apposition_middle, &mesh.apposition_top};
  const std::size_t lines = line[0]->particles.size();
  double sum = 0.0;
  for (std::size_t k = 0; k < lines; ++k)
    for (std::size_t part = 0; part + 1 < std::size(line); ++part) {
      const auto below = static_cast<std::size_t>(line[part]->particles[k]);
      const auto above = static_cast<std::size_t>(line[part + 1]->particles[k]);
      sum += norm(position[above] - position[below]);
    }
  return sum / static_cast<double>(lines);
}

double half_width(const Level& level, std::span<const Vec3d> position) {
  double left = 0.0, right = 0.0;
  for (int i : level.particles) {
    left = std::min(left, position[static_cast<std::size_t>(i)].x());
    right = std::max(right, position[static_cast<std::size_t>(i)].x());
  }
  return 0.5 * (right - left);
}

}  // namespace

Shape shape_of(const Trunk& trunk, std::span<const Vec3d> position) {
  const TemplateMesh& mesh = trunk.mesh;
  const auto on_right = [&](std::size_t k) {
    return trunk.model.rest[static_cast<std::size_t>(mesh.dome_top.particles[k])].x() > 0.0;
  };
  Shape shape;
  shape.lung_volume = enclosed_volume<double>(mesh.lung, position);
  shape.apposition_length = mean_line_length(mesh, position);
  shape.right_dome = mean_height(mesh.dome_top, position, on_right);
  shape.left_dome = mean_height(mesh.dome_top, position, [&](std::size_t k) { return !on_right(k); });
  const double top = mean_height(mesh.apposition_top, position, [](std::size_t) { return true; });
  shape.dome_height = 0.5 * (shape.right_dome + shape.left_dome) - top;
  shape.half_width =
      0.5 * (half_width(mesh.apposition_middle, position) + half_width(mesh.apposition_top, position));
  return shape;
}

Measures measures_between(const Shape& before, const Shape& after) {
  Measures m;
  m.end_expiratory_volume = before.lung_volume;
  m.end_inspiratory_volume = after.lung_volume;
  m.delta_v = after.lung_volume - before.lung_volume;
  m.delta_l = before.apposition_length - after.apposition_length;
  m.delta_l_fraction = m.delta_l / before.apposition_length;
  m.delta_h = before.dome_height - after.dome_height;
  m.delta_r = after.half_width - before.half_width;
  m.excursion_right = before.right_dome - after.right_dome;
  m.excursion_left = before.left_dome - after.left_dome;
  return m;
}

}  // namespace trunk
