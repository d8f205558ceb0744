#include "mesh/surface.hpp"

#include <fmt/format.h>

#include <map>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

std::string text(const Triangle& t) {
  return fmt::format("({} {} {})", t[0], t[1], t[2]);
}

[[noreturn]] void refuse(const std::string& surface, const std::string& found, const std::string& expected) {
  throw InputError({}, fmt::format("surface '{}': {}", surface, found), expected);
}

void require_valid_indices(const std::string& name, const Triangle& t, int particles) {
  for (int i : t)
    if (i < 0 || i >= particles)
      refuse(name, fmt::format("triangle {} refers to particle {}", text(t), i),
             fmt::format("0 to {}", particles - 1));
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    refuse(name, fmt::format("triangle {} repeats a particle", text(t)), "three different ones");
}

/// For each vertex, a map from each neighbour to the next one counter-clockwise.
using Fans = std::map<int, std::map<int, int>>;

Fans fans_of(const std::string& name, std::span<const Triangle> triangles) {
  Fans fans;
  for (const Triangle& t : triangles)
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = t[static_cast<std::size_t>(corner)];
      const int from = t[static_cast<std::size_t>((corner + 1) % 3)];
      const int to = t[static_cast<std::size_t>((corner + 2) % 3)];
      if (!fans[vertex].emplace(from, to).second)
        refuse(name, fmt::format("edge {}-{} is used twice in the same direction", vertex, from),
               "a manifold surface whose triangles are all counter-clockwise seen from outside");
    }
  return fans;
}

std::vector<int> closed_ring(const std::string& name, int vertex, const std::map<int, int>& fan) {
  std::vector<int> ring;
  int at = fan.begin()->first;
  do {
    ring.push_back(at);
    const auto next = fan.find(at);
    if (next == fan.end())
      refuse(name, fmt::format("edge {}-{} belongs to one triangle only", vertex, at), "a closed surface");
    at = next->second;
  } while (at != ring.front() && ring.size() <= fan.size());
  if (ring.size() != fan.size())
    refuse(name, fmt::format("the triangles around particle {} do not form one closed fan", vertex),
           "a manifold surface");
  return ring;
}

}  // namespace

Surface::Surface(std::string name, std::vector<Triangle> triangles, int particles)
    : name_(std::move(name)), triangles_(std::move(triangles)) {
  if (triangles_.empty()) throw InputError({}, fmt::format("surface '{}' has no triangle", name_));
  for (const Triangle& t : triangles_) require_valid_indices(name_, t, particles);
  for (const auto& [vertex, fan] : fans_of(name_, triangles_))
    one_rings_.push_back({vertex, closed_ring(name_, vertex, fan)});
}

}  // namespace trunk
