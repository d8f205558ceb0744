#include "anatomy/measures.hpp"

#include <algorithm>

#include "mesh/volume.hpp"

namespace trunk {
namespace {

double mean_height(const std::vector<int>& particles, std::span<const Vec3d> position) {
  double sum = 0.0;
  for (int i : particles) sum += position[static_cast<std::size_t>(i)].z();
  return sum / static_cast<double>(particles.size());
}

/// Returns the mean length of the muscle lines from the costal insertion to the top of the zone of
/// apposition.
double mean_line_length(const TrunkMesh& mesh, std::span<const Vec3d> position) {
  const std::size_t top = mesh.apposition_top_row();
  const auto at = [&](int i) { return position[static_cast<std::size_t>(i)]; };
  double sum = 0.0;
  for (const auto& line : mesh.muscle_lines)
    for (std::size_t row = 0; row < top; ++row) sum += norm(at(line[row + 1]) - at(line[row]));
  return sum / static_cast<double>(mesh.muscle_lines.size());
}

double half_width(const std::vector<int>& particles, std::span<const Vec3d> position) {
  const auto by_x = [&](int a, int b) {
    return position[static_cast<std::size_t>(a)].x() < position[static_cast<std::size_t>(b)].x();
  };
  const auto [left, right] = std::minmax_element(particles.begin(), particles.end(), by_x);
  return 0.5 *
         (position[static_cast<std::size_t>(*right)].x() - position[static_cast<std::size_t>(*left)].x());
}

}  // namespace

Shape shape_of(const Trunk& trunk, std::span<const Vec3d> position) {
  const TrunkMesh& mesh = trunk.mesh;
  Shape shape;
  shape.lung_volume = enclosed_volume<double>(mesh.lung, position);
  shape.apposition_length = mean_line_length(mesh, position);
  shape.right_dome = mean_height(mesh.named("dome_top_right"), position);
  shape.left_dome = mean_height(mesh.named("dome_top_left"), position);
  shape.dome_height =
      0.5 * (shape.right_dome + shape.left_dome) - mean_height(mesh.named("apposition_top"), position);
  shape.half_width = 0.5 * (half_width(mesh.named("apposition_middle"), position) +
                            half_width(mesh.named("apposition_top"), position));
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
