#pragma once

#include <span>
#include <vector>

#include "mesh/surface.hpp"

namespace trunk {

/// The one-rings of a closed surface, flat in memory and sorted by valence, so that a loop over the
/// neighbours knows its length at compile time (see for_each_ring).
struct RingTable {
  struct Group {
    int valence;
    int first, last;      // rings [first, last)
    int first_neighbour;  // of ring `first`
  };
  std::vector<Group> groups;
  std::vector<int> vertex;     // [rings] the particle in the middle
  std::vector<int> neighbour;  // [sum of valences] counter-clockwise seen from outside

  std::size_t size() const noexcept { return vertex.size(); }
};

RingTable ring_table(const Surface& surface);

/// Calls visit(ring, vertex, neighbours) for every ring; `neighbours` is a span of const int whose extent is
/// the valence where that is 4 to 8, the usual ones, and dynamic elsewhere.
template <class Visit>
void for_each_ring(const RingTable& table, Visit&& visit) noexcept {
  const auto visit_group = [&]<std::size_t Valence>(const RingTable::Group& group) {
    const auto valence = Valence == std::dynamic_extent ? static_cast<std::size_t>(group.valence) : Valence;
    const int* neighbour = table.neighbour.data() + group.first_neighbour;
    for (auto r = static_cast<std::size_t>(group.first); r < static_cast<std::size_t>(group.last); ++r) {
      visit(r, static_cast<std::size_t>(table.vertex[r]), std::span<const int, Valence>(neighbour, valence));
      neighbour += valence;
    }
  };
  for (const RingTable::Group& group : table.groups) switch (group.valence) {
      case 4:
        visit_group.template operator()<4>(group);
        break;
      case 5:
        visit_group.template operator()<5>(group);
        break;
      case 6:
        visit_group.template operator()<6>(group);
        break;
      case 7:
        visit_group.template operator()<7>(group);
        break;
      case 8:
        visit_group.template operator()<8>(group);
        break;
      default:
        visit_group.template operator()<std::dynamic_extent>(group);
    }
}

}  // namespace trunk
