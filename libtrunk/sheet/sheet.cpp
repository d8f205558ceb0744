#include "sheet/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "forces/shape_memory.hpp"
#include "mesh/areas.hpp"
#include "sheet/ring_weights.hpp"

namespace trunk {
namespace {

/// The part of a ring that lies beside a clamped area.
struct FreeSide {
  std::vector<std::size_t> particles;  // in ring order
  Vec3d normal, inward;                // unit vectors: of its surface, and from the border into it
  double area = 0.0;                   // m2, the particle's share of the triangles that can bend
};

Vec3d unit(const Vec3d& a) {
  return (1.0 / norm(a)) * a;
}

/// Returns the free side of a ring; one without particles if there is no such side, or more than
/// one.
FreeSide free_side(std::size_t vertex, std::span<const Neighbour> ring, std::span<const Vec3d> rest,
                   const std::vector<bool>& clamped) {
  const std::size_t m = ring.size();
  const auto at = [&](std::size_t j) { return ring[j % m].in(rest)-rest[vertex]; };
  const auto held = [&](std::size_t j) { return clamped[static_cast<std::size_t>(ring[j % m].particle())]; };
  FreeSide side;
  std::size_t begins = 0, sides = 0;
  for (std::size_t j = 0; j < m; ++j)
    if (held(j) && !held(j + 1)) {
      begins = j;
      ++sides;
    }
  if (sides != 1) return side;
  std::size_t ends = begins + 1;  // the next clamped neighbour
  Vec3d area;
  for (;; ++ends) {
    const Vec3d twice = cross(at(ends - 1), at(ends));
    area += twice;
    side.area += norm(twice) / 6.0;
    if (held(ends)) break;
    side.particles.push_back(static_cast<std::size_t>(ring[ends % m].particle()));
  }
  if (ends == begins + m) return {};  // the end of a clamped line
  side.normal = unit(area);
  side.inward = unit(cross(side.normal, at(begins) - at(ends)));
  return side;
}

}  // namespace

std::vector<double> lay_sheet(std::span<const Triangle> triangles, std::span<const Vec3d> rest,
                              ShapeMemory& memory) {
  const std::vector<double> area = particle_areas(triangles, rest);
  std::vector<double> factor(rest.size(), 1.0), weights;
  for_each_ring(memory.rings, [&](std::size_t row, std::size_t vertex, auto ring) {
    std::vector<Vec3d> offset;
    for (const Neighbour n : ring) offset.push_back(n.in(rest)-rest[vertex]);
    const std::vector<double> of_ring = ring_weights(offset, unit(twice_area<double>(offset)));
    double square = 0.0;
    for (std::size_t j = 0; j < offset.size(); ++j) square += of_ring[j] * dot(offset[j], offset[j]);
    const double coarser = sheet_spacing * sheet_spacing / square;
    factor[vertex] = area[vertex] / sheet_area * coarser * coarser;
    memory.stiffness_weight[row] *= factor[vertex];
    weights.insert(weights.end(), of_ring.begin(), of_ring.end());
  });
  weigh_neighbours(weights, rest, memory);
  return factor;
}

void stiffen_borders(std::span<const Vec3d> rest, const std::vector<bool>& clamped,
                     const std::vector<bool>& border, std::span<const double> factor, ShapeMemory& memory) {
  constexpr double curvature = 1e-2;  // 1/m, so small that the ring answers in proportion
  std::vector<Vec3d> bent(rest.begin(), rest.end());
  for_each_ring(memory.rings, [&](std::size_t row, std::size_t vertex, auto ring) {
    if (!border[vertex]) return;
    const FreeSide side = free_side(vertex, ring, rest, clamped);
    if (side.particles.empty()) return;
    Vec3d answer;
    for (const double sense : {0.5, -0.5}) {
      for (const std::size_t i : side.particles) {
        const double d = dot(rest[i] - rest[vertex], side.inward);
        bent[i] = rest[i] + (sense * curvature * d * d) * side.normal;
      }
      answer += (sense / curvature) * target_of(memory, row, ring, bent);
    }
    for (const std::size_t i : side.particles) bent[i] = rest[i];
    const double one_sided = bending_stiffness(1.0) * side.area / dot(answer, answer);
    memory.stiffness_weight[row] *= one_sided / factor[vertex];
  });
}

}  // namespace trunk
