#include "mesh/ring_table.hpp"

#include <algorithm>

namespace trunk {

RingTable ring_table(const Surface& surface) {
  std::vector<Surface::OneRing> rings(surface.one_rings().begin(), surface.one_rings().end());
  std::stable_sort(rings.begin(), rings.end(),
                   [](const auto& a, const auto& b) { return a.neighbours.size() < b.neighbours.size(); });
  RingTable table;
  for (const auto& [vertex, neighbours] : rings) {
    const int valence = static_cast<int>(neighbours.size());
    const int row = static_cast<int>(table.vertex.size());
    if (table.groups.empty() || table.groups.back().valence != valence)
      table.groups.push_back({valence, row, row, static_cast<int>(table.neighbour.size())});
    ++table.groups.back().last;
    table.vertex.push_back(vertex);
    for (const int neighbour : neighbours) table.neighbour.emplace_back(neighbour);
  }
  return table;
}

}  // namespace trunk
