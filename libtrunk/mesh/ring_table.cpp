#include "mesh/ring_table.hpp"

#include <algorithm>
#include <map>

namespace trunk {
namespace {

/// Adds a ring. Its valence is not smaller than that of the last ring.
void append(int vertex, std::span<const Neighbour> neighbours, RingTable& table) {
  const int valence = static_cast<int>(neighbours.size());
  const int row = static_cast<int>(table.vertex.size());
  if (table.groups.empty() || table.groups.back().valence != valence)
    table.groups.push_back({valence, row, row, static_cast<int>(table.neighbour.size())});
  ++table.groups.back().last;
  table.vertex.push_back(vertex);
  table.neighbour.insert(table.neighbour.end(), neighbours.begin(), neighbours.end());
}

bool same(Neighbour a, Neighbour b) {
  return a.particle() == b.particle();
}

/// Returns whether two rings are the same. They may begin at different neighbours.
bool same_round(std::span<const Neighbour> a, std::span<const Neighbour> b) {
  if (a.size() != b.size()) return false;
  const auto begins = std::find_if(a.begin(), a.end(), [&](Neighbour n) { return same(n, b.front()); });
  const auto before_end = a.end() - begins;
  return std::equal(begins, a.end(), b.begin(), same) &&
         std::equal(a.begin(), begins, b.begin() + before_end, same);
}

}  // namespace

RingTable ring_table(std::span<const Surface::OneRing> some) {
  std::vector<Surface::OneRing> rings(some.begin(), some.end());
  std::stable_sort(rings.begin(), rings.end(),
                   [](const auto& a, const auto& b) { return a.neighbours.size() < b.neighbours.size(); });
  RingTable table;
  for (const auto& [vertex, neighbours] : rings)
    append(vertex, std::vector<Neighbour>(neighbours.begin(), neighbours.end()), table);
  return table;
}

RingTable only_those(const RingTable& table,
                     const std::function<bool(int, std::span<const Neighbour>)>& wanted) {
  RingTable result;
  for_each_ring(table, [&](std::size_t, std::size_t vertex, auto ring) {
    if (wanted(static_cast<int>(vertex), ring)) append(static_cast<int>(vertex), ring, result);
  });
  return result;
}

bool any_of_ring(const std::vector<bool>& mask, int vertex, std::span<const Neighbour> neighbours) {
  const auto holds = [&](int particle) { return mask[static_cast<std::size_t>(particle)]; };
  return holds(vertex) ||
         std::any_of(neighbours.begin(), neighbours.end(), [&](Neighbour n) { return holds(n.particle()); });
}

RingTable turned_over(const RingTable& table) {
  RingTable result;
  for_each_ring(table, [&](std::size_t, std::size_t vertex, auto ring) {
    append(static_cast<int>(vertex), std::vector<Neighbour>(ring.rbegin(), ring.rend()), result);
  });
  return result;
}

bool contains(const RingTable& table, int vertex, std::span<const Neighbour> neighbours) {
  bool found = false;
  for_each_ring(table, [&](std::size_t, std::size_t other, auto ring) {
    found = found || (static_cast<int>(other) == vertex && same_round(ring, neighbours));
  });
  return found;
}

bool contains(const RingTable& all, const RingTable& some) {
  std::map<std::size_t, std::span<const Neighbour>> around;
  for_each_ring(all, [&](std::size_t, std::size_t vertex, auto ring) { around[vertex] = ring; });
  bool found = true;
  for_each_ring(some, [&](std::size_t, std::size_t vertex, auto ring) {
    found = found && around.contains(vertex) && same_round(around[vertex], ring);
  });
  return found;
}

}  // namespace trunk
