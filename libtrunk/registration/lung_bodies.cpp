#include "registration/lung_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

/// Gives each solid cell the body of the nearest cell that has one, on the way through solid cells. => body
void spread_bodies(const Voxels& solid, std::vector<int>& body) {
  std::vector<std::size_t> front;
  for (std::size_t c = 0; c < body.size(); ++c)
    if (body[c] >= 0) front.push_back(c);
  while (!front.empty()) {
    std::vector<std::size_t> next;
    for (const std::size_t c : front)
      solid.around(c, false, [&](std::size_t near) {
        if (solid[near] == 0 || body[near] >= 0) return;
        body[near] = body[c];
        next.push_back(near);
      });
    front = std::move(next);
  }
}

/// Returns the mean place of the cells of each set.
std::vector<Vec3d> middles_of_sets(const Voxels& cells, const std::vector<int>& set,
                                   const std::vector<std::size_t>& sizes) {
  std::vector<Vec3d> middles(sizes.size());
  for (std::size_t c = 0; c < set.size(); ++c)
    if (set[c] >= 0) {
      const auto s = static_cast<std::size_t>(set[c]);
      middles[s] += (1.0 / static_cast<double>(sizes[s])) * cells.centre(c);
    }
  return middles;
}

}  // namespace

Bodies bodies_of(const MeasuredSurface& lungs) {
  constexpr int fissure = 1, windpipe = 4;  // steps; a windpipe is up to 22 mm wide
  constexpr double least_share = 0.2;       // of the larger body
  constexpr double beside_middle = 0.25;    // of the distance between the bodies
  Bodies bodies{solid_within(lungs).grown(fissure).shrunk(fissure), {}, 1, 0};
  Voxels& solid = bodies.solid;
  const Voxels core = solid.shrunk(windpipe);
  std::vector<std::size_t> sizes;
  std::vector<int> set = core.sets(sizes);
  const std::vector<Vec3d> middle = middles_of_sets(core, set, sizes);
  std::vector<std::size_t> order(sizes.size());
  for (std::size_t s = 0; s < order.size(); ++s) order[s] = s;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return sizes[a] > sizes[b]; });
  if (order.size() > 1 &&
      static_cast<double>(sizes[order[1]]) > least_share * static_cast<double>(sizes[order[0]]))
    bodies.count = 2;
  else {
    bodies.body.assign(solid.count(), -1);
    for (std::size_t c = 0; c < solid.count(); ++c)
      if (solid[c] != 0) bodies.body[c] = 0;
    return bodies;
  }
  if (middle[order[0]].x() > middle[order[1]].x()) std::swap(order[0], order[1]);
  const Vec3d &first = middle[order[0]], &second = middle[order[1]];

  // What no ball of the size of a windpipe reaches is thin. Thin parts half-way between the bodies are not
  // lung.
  Voxels thin = solid;
  const Voxels thick = core.grown(windpipe + 1);
  for (std::size_t c = 0; c < solid.count(); ++c)
    if (thick[c] != 0) thin[c] = 0;
  std::vector<std::size_t> thin_sizes;
  const std::vector<int> thin_set = thin.sets(thin_sizes);
  const std::vector<Vec3d> thin_middle = middles_of_sets(thin, thin_set, thin_sizes);
  const double between = dot(second - first, second - first);
  for (std::size_t c = 0; c < solid.count(); ++c) {
    if (thin_set[c] < 0) continue;
    const double at =
        dot(thin_middle[static_cast<std::size_t>(thin_set[c])] - first, second - first) / between;
    if (std::abs(at - 0.5) > beside_middle) continue;
    solid[c] = 0;
    ++bodies.dropped;
  }
  bodies.body.assign(solid.count(), -1);
  for (std::size_t c = 0; c < solid.count(); ++c) {
    if (set[c] == static_cast<int>(order[0])) bodies.body[c] = 0;
    if (set[c] == static_cast<int>(order[1])) bodies.body[c] = 1;
  }
  spread_bodies(solid, bodies.body);
  return bodies;
}

}  // namespace trunk
