#include "mesh/fans.hpp"

#include <algorithm>
#include <queue>

namespace trunk {
namespace {

constexpr std::size_t most_corners = 8;

/// The triangles that no fan has taken yet, by their corners.
class Untaken {
 public:
  explicit Untaken(std::span<const Triangle> triangles) : taken_(triangles.size(), false) {
    int particles = 0;
    for (const Triangle& t : triangles)
      particles = std::max(particles, 1 + *std::max_element(t.begin(), t.end()));
    around_.resize(static_cast<std::size_t>(particles));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t corner = 0; corner < 3; ++corner)
        around_[static_cast<std::size_t>(triangles[t][corner])].push_back(
            {triangles[t][(corner + 1) % 3], triangles[t][(corner + 2) % 3], t});
  }

  int particles() const { return static_cast<int>(around_.size()); }

  /// Triangles around a centre. Each begins where the one before ends.
  struct Fan {
    bool closed = false;
    std::vector<int> rim;  // the corners in order; an open fan has one more of them than triangles
    std::vector<std::size_t> triangles;
  };

  /// Returns the first fan that is found around a centre, no longer than a polygon may be.
  Fan fan_around(int centre) const {
    std::vector<Edge> edges;
    for (const Edge& e : around_[static_cast<std::size_t>(centre)])
      if (!taken_[e.triangle]) edges.push_back(e);
    Fan fan;
    if (edges.empty()) return fan;
    const auto begins_at = [&](int particle) {
      return std::find_if(edges.begin(), edges.end(), [&](const Edge& e) { return e.from == particle; });
    };
    const auto is_reached = [&](const Edge& one) {
      return std::any_of(edges.begin(), edges.end(), [&](const Edge& e) { return e.to == one.from; });
    };
    auto edge = std::find_if_not(edges.begin(), edges.end(), is_reached);
    const bool goes_round = edge == edges.end();
    fan.closed = goes_round && edges.size() <= most_corners;
    if (goes_round) edge = edges.begin();
    const std::size_t most = fan.closed ? most_corners : most_corners - 2;
    fan.rim.push_back(edge->from);
    while (edge != edges.end() && fan.triangles.size() < most) {
      fan.triangles.push_back(edge->triangle);
      fan.rim.push_back(edge->to);
      edge = fan.closed && edge->to == fan.rim.front() ? edges.end() : begins_at(edge->to);
    }
    if (fan.closed) fan.rim.pop_back();
    return fan;
  }

  void take(const Fan& fan) {
    for (const std::size_t t : fan.triangles) taken_[t] = true;
  }

 private:
  struct Edge {
    int from, to;
    std::size_t triangle;
  };
  std::vector<std::vector<Edge>> around_;  // [particles]
  std::vector<bool> taken_;
};

std::vector<int> polygon(int centre, const Untaken::Fan& fan) {
  std::vector<int> corners = fan.rim;
  if (!fan.closed) corners.push_back(centre);
  while (corners.size() < 4 || corners.size() % 2 != 0) corners.push_back(corners.back());
  return corners;
}

}  // namespace

RingTable fans(std::span<const Triangle> triangles) {
  Untaken untaken(triangles);
  using Entry = std::pair<std::size_t, int>;  // the number of triangles at its last count, centre
  std::priority_queue<Entry> longest;
  for (int i = 0; i < untaken.particles(); ++i) longest.emplace(untaken.fan_around(i).triangles.size(), i);
  std::vector<Surface::OneRing> polygons;
  while (!longest.empty() && longest.top().first > 0) {
    const auto [expected, centre] = longest.top();
    longest.pop();
    const Untaken::Fan fan = untaken.fan_around(centre);
    if (fan.triangles.size() == expected) {
      untaken.take(fan);
      polygons.push_back({centre, polygon(centre, fan)});
    }
    longest.emplace(untaken.fan_around(centre).triangles.size(), centre);
  }
  return ring_table(polygons);
}

}  // namespace trunk
