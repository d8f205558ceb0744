#include "surface/voxels.hpp"

#include <algorithm>
#include <cmath>

#include "surface/facets.hpp"

namespace trunk {
namespace {

constexpr int margin = 8;  // empty cells around a surface

std::array<double, 3> numbers_of_point(const Vec3d& p) {
  return {p.x(), p.y(), p.z()};
}

}  // namespace

Voxels::Voxels(const MeasuredSurface& surface) : edge_(0.003), size_{} {
  constexpr double most_cells = 150.0;
  std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Triangle& t : surface.triangles)
    for (const int corner : t) {
      const auto p = numbers_of_point(point_of(surface.points, corner));
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
  for (std::size_t k = 0; k < 3; ++k) edge_ = std::max(edge_, (high[k] - low[k]) / most_cells);
  std::size_t count = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    size_[k] = static_cast<int>(std::ceil((high[k] - low[k]) / edge_)) + 2 * margin + 1;
    count *= static_cast<std::size_t>(size_[k]);
  }
  low_ = Vec3d(low[0], low[1], low[2]) - (margin * edge_) * Vec3d(1, 1, 1);
  values_.assign(count, 0);
}

std::size_t Voxels::index(const Vec3d& p) const noexcept {
  const auto at = numbers_of_point((1.0 / edge_) * (p - low_));
  Cell cell;
  for (std::size_t k = 0; k < 3; ++k) cell[k] = std::clamp(static_cast<int>(at[k]), 0, size_[k] - 1);
  return index(cell[0], cell[1], cell[2]);
}

Vec3d Voxels::centre(std::size_t index) const noexcept {
  const auto width = static_cast<std::size_t>(size_[0]), depth = static_cast<std::size_t>(size_[1]);
  const auto at = [&](std::size_t i) { return edge_ * (static_cast<double>(i) + 0.5); };
  return low_ + Vec3d(at(index % width), at(index / width % depth), at(index / (width * depth)));
}

Voxels Voxels::grown(int steps) const {
  Voxels result = *this;
  std::vector<std::size_t> front;
  for (std::size_t c = 0; c < count(); ++c)
    if (values_[c] != 0) front.push_back(c);
  for (int step = 0; step < steps; ++step) {
    std::vector<std::size_t> next;
    for (const std::size_t c : front)
      around(c, step % 2 == 1, [&](std::size_t near) {
        if (result[near] != 0) return;
        result[near] = 1;
        next.push_back(near);
      });
    front = std::move(next);
  }
  return result;
}

Voxels Voxels::opposite() const {
  Voxels result = *this;
  for (char& value : result.values_) value = value == 0 ? 1 : 0;
  return result;
}

Voxels Voxels::shrunk(int steps) const {
  return opposite().grown(steps).opposite();
}

std::vector<int> Voxels::sets(std::vector<std::size_t>& sizes) const {
  std::vector<int> number(count(), -1);
  sizes.clear();
  for (std::size_t seed = 0; seed < count(); ++seed) {
    if (values_[seed] == 0 || number[seed] >= 0) continue;
    const int set = static_cast<int>(sizes.size());
    std::vector<std::size_t> todo{seed};
    number[seed] = set;
    sizes.push_back(0);
    while (!todo.empty()) {
      const std::size_t c = todo.back();
      todo.pop_back();
      ++sizes.back();
      around(c, true, [&](std::size_t near) {
        if (values_[near] == 0 || number[near] >= 0) return;
        number[near] = set;
        todo.push_back(near);
      });
    }
  }
  return number;
}

Voxels solid_within(const MeasuredSurface& surface) {
  Voxels solid(surface);
  for (const Triangle& t : surface.triangles) {
    const Vec3d &a = point_of(surface.points, t[0]), &b = point_of(surface.points, t[1]),
                &c = point_of(surface.points, t[2]);
    const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
    const int parts = 1 + static_cast<int>(2.0 * longest / solid.edge());
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j)
        solid[solid.index(a + (static_cast<double>(i) / parts) * (b - a) +
                          (static_cast<double>(j) / parts) * (c - a))] = 1;
  }
  // What the empty corner of the box does not reach is inside.
  Voxels empty = solid.opposite();
  std::vector<std::size_t> todo{0};
  empty[0] = 2;
  while (!todo.empty()) {
    const std::size_t c = todo.back();
    todo.pop_back();
    empty.around(c, false, [&](std::size_t near) {
      if (empty[near] != 1) return;
      empty[near] = 2;
      todo.push_back(near);
    });
  }
  for (std::size_t c = 0; c < solid.count(); ++c) solid[c] = empty[c] != 2 ? 1 : 0;
  return solid;
}

}  // namespace trunk
