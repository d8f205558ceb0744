#include "mesh/ring_table.hpp"

#include <algorithm>
#include <map>

namespace trunk {
namespace {

/// Adds a ring of a valence no smaller than the last one's.
void append(int vertex, std::span<const int> neighbours, RingTable& table) {
  const int valence = static_cast<int>(neighbours.size());
  const int row = static_cast<int>(table.vertex.size());
  if (table.groups.empty() || table.groups.back().valence != valence)
    table.groups.push_back({valence, row, row, static_cast<int>(table.neighbour.size())});
  ++table.groups.back().last;
  table.vertex.push_back(vertex);
  for (const int neighbour : neighbours) table.neighbour.emplace_back(neighbour);
}

std::vector<int> particles(std::span<const Neighbour> ring) {
  std::vector<int> numbers;
  for (const Neighbour n : ring) numbers.push_back(n.particle());
  return numbers;
}

}  // namespace

RingTable ring_table(std::span<const Surface::OneRing> some) {
  std::vector<Surface::OneRing> rings(some.begin(), some.end());
  std::stable_sort(rings.begin(), rings.end(),
                   [](const auto& a, const auto& b) { return a.neighbours.size() < b.neighbours.size(); });
  RingTable table;
  for (const auto& [vertex, neighbours] : rings) append(vertex, neighbours, table);
  return table;
}

RingTable only_those(const RingTable& table,
                     const std::function<bool(int, std::span<const Neighbour>)>& wanted) {
  RingTable result;
  for_each_ring(table, [&](std::size_t, std::size_t vertex, auto ring) {
    if (wanted(static_cast<int>(vertex), ring)) append(static_cast<int>(vertex), particles(ring), result);
  });
  return result;
}

bool any_of_ring(const std::vector<bool>& mask, int vertex, std::span<const Neighbour> neighbours) {
  const auto holds = [&](int particle) { return mask[static_cast<std::size_t>(particle)]; };
  return holds(vertex) ||
         std::any_of(neighbours.begin(), neighbours.end(), [&](Neighbour n) { return holds(n.particle()); });
}

bool contains(const RingTable& all, const RingTable& some) {
  std::map<std::size_t, std::vector<int>> twice_round;
  for_each_ring(all, [&](std::size_t, std::size_t vertex, auto ring) {
    const std::vector<int> once = particles(ring);
    auto& twice = twice_round[vertex] = once;
    twice.insert(twice.end(), once.begin(), once.end());
  });
  bool found = true;
  for_each_ring(some, [&](std::size_t, std::size_t vertex, auto ring) {
    const std::vector<int> once = particles(ring);
    const auto& twice = twice_round[vertex];
    found = found && twice.size() == 2 * once.size() &&
            std::search(twice.begin(), twice.end(), once.begin(), once.end()) != twice.end();
  });
  return found;
}

}  // namespace trunk
