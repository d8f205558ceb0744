#include "surface/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "surface/facets.hpp"
#include "surface/sets.hpp"

namespace trunk {
namespace {

/// Gives sets new numbers from 0, in the order in which they come.
class Numbering {
 public:
  int operator()(int set) {
    return numbers_.try_emplace(set, static_cast<int>(numbers_.size())).first->second;
  }

 private:
  std::unordered_map<int, int> numbers_;
};

/// How a patch faces. `away` is positive if the patch faces away from its middle; for a closed patch it is
/// three times the volume.
struct Facing {
  Vec3d weighted_centre, net;
  double area = 0.0, away = 0.0, reach = 0.0;
};

}  // namespace

std::vector<int> connected_parts(std::span<const Triangle> triangles, std::size_t points) {
  Sets sets(points);
  for (const Triangle& t : triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  Numbering number;
  std::vector<int> parts;
  for (const Triangle& t : triangles) parts.push_back(number(sets.find(t[0])));
  return parts;
}

Patches orient_patches(std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> sides;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      sides[std::minmax(triangles[i][k], triangles[i][(k + 1) % 3])].push_back(i);
  const auto runs = [](const Triangle& t, int a, int b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  };
  Patches patches{std::vector<int>(triangles.size(), -1), 0, true};
  int count = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (patches.number[seed] >= 0) continue;
    std::vector<std::size_t> todo{seed}, members;
    std::size_t turned = 0;
    patches.number[seed] = count;
    while (!todo.empty()) {
      const std::size_t i = todo.back();
      todo.pop_back();
      members.push_back(i);
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangles[i][k], b = triangles[i][(k + 1) % 3];
        const auto& pair = sides.at(std::minmax(a, b));
        if (pair.size() != 2) continue;
        const std::size_t other = pair[0] == i ? pair[1] : pair[0];
        const bool agrees = runs(triangles[other], b, a);
        if (patches.number[other] >= 0) {
          patches.possible = patches.possible && agrees;
          continue;
        }
        patches.number[other] = count;
        if (!agrees) {
          std::swap(triangles[other][1], triangles[other][2]);
          ++turned;
        }
        todo.push_back(other);
      }
    }
    patches.turned += std::min(turned, members.size() - turned);
    ++count;
  }
  return patches;
}

void face_outward(MeasuredSurface& s) {
  const Patches patches = orient_patches(s.triangles);
  std::vector<Facing> facing;
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto number = static_cast<std::size_t>(patches.number[i]);
    if (facing.size() <= number) facing.resize(number + 1);
    const Vec3d normal = area_vector(s.points, s.triangles[i]);
    facing[number].area += norm(normal);
    facing[number].net += normal;
    facing[number].weighted_centre += norm(normal) * centre_of(s.points, s.triangles[i]);
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    Facing& f = facing[static_cast<std::size_t>(patches.number[i])];
    const Vec3d normal = area_vector(s.points, s.triangles[i]);
    const Vec3d out =
        centre_of(s.points, s.triangles[i]) - (1.0 / std::max(f.area, 1e-300)) * f.weighted_centre;
    f.away += dot(normal, out);
    f.reach += norm(normal) * norm(out);
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const Facing& f = facing[static_cast<std::size_t>(patches.number[i])];
    constexpr double flat = 0.02;
    const double out = std::abs(f.away) > flat * f.reach ? f.away : f.net.z();
    if (out < 0.0) std::swap(s.triangles[i][1], s.triangles[i][2]);
  }
}

}  // namespace trunk
