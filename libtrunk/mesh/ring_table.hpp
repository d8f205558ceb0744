#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// A particle in a ring. It is kept as four times its number, so that its 32 bytes in an array are found
/// without a shift: an x86 address multiplies by 8 for free.
class Neighbour {
 public:
  constexpr explicit Neighbour(int particle) noexcept : quarters_(4 * particle) {}

  constexpr int particle() const noexcept { return quarters_ / 4; }

  template <class Value>
  Value& in(std::span<Value> field) const noexcept {
    static_assert(sizeof(Value) % 4 == 0);
    using Byte = std::conditional_t<std::is_const_v<Value>, const std::byte, std::byte>;
    return *reinterpret_cast<Value*>(reinterpret_cast<Byte*>(field.data()) +
                                     quarters_ * static_cast<std::ptrdiff_t>(sizeof(Value) / 4));
  }

 private:
  int quarters_;
};

/// The one-rings of a closed surface, flat in memory and sorted by valence. A loop over the neighbours thus
/// knows its length at compile time (see for_each_ring).
struct RingTable {
  struct Group {
    int valence;
    int first, last;      // rings [first, last)
    int first_neighbour;  // the index in `neighbour` where ring `first` begins
  };
  std::vector<Group> groups;
  std::vector<int> vertex;           // [rings] the particle in the middle of each
  std::vector<Neighbour> neighbour;  // [sum of valences] counter-clockwise seen from outside

  std::size_t size() const noexcept { return vertex.size(); }
};

/// Returns the rings as a table.
RingTable ring_table(std::span<const Surface::OneRing> rings);
inline RingTable ring_table(const Surface& surface) {
  return ring_table(surface.one_rings());
}

/// Returns the rings for which `wanted(vertex, neighbours)` is true, in the same order.
RingTable only_those(const RingTable& table,
                     const std::function<bool(int, std::span<const Neighbour>)>& wanted);

/// Returns whether the mask is true for the vertex of a ring or for one of its neighbours. mask: [particles].
bool any_of_ring(const std::vector<bool>& mask, int vertex, std::span<const Neighbour> neighbours);

/// Returns the rings as they look from the other side.
RingTable turned_over(const RingTable& table);

/// Returns whether a table has a ring. The two may begin at different neighbours.
bool contains(const RingTable& table, int vertex, std::span<const Neighbour> neighbours);

/// Returns whether every ring of `some` is also in `all`. The two may begin at different neighbours.
bool contains(const RingTable& all, const RingTable& some);

/// Calls visit.template operator()<Valence>(group) for every group. Valences from 4 to 8, the usual ones, are
/// compile-time numbers; for all others Valence is std::dynamic_extent.
template <class Visit>
void for_each_valence(const RingTable& table, Visit&& visit) noexcept {
  for (const RingTable::Group& group : table.groups) switch (group.valence) {
      case 4:
        visit.template operator()<4>(group);
        break;
      case 5:
        visit.template operator()<5>(group);
        break;
      case 6:
        visit.template operator()<6>(group);
        break;
      case 7:
        visit.template operator()<7>(group);
        break;
      case 8:
        visit.template operator()<8>(group);
        break;
      default:
        visit.template operator()<std::dynamic_extent>(group);
    }
}

/// Returns the neighbours of a ring of a group.
template <std::size_t Valence>
std::span<const Neighbour, Valence> neighbours_of(const RingTable& table, const RingTable::Group& group,
                                                  int ring) noexcept {
  const auto valence = Valence == std::dynamic_extent ? static_cast<std::size_t>(group.valence) : Valence;
  const auto rank = static_cast<std::size_t>(ring - group.first);
  return std::span<const Neighbour, Valence>(
      table.neighbour.data() + static_cast<std::size_t>(group.first_neighbour) + rank * valence, valence);
}

/// Returns the numbers of a ring in a field that has one for each neighbour of the table. ring: a part of
/// table.neighbour
inline const double* of_ring(const std::vector<double>& field, const RingTable& table,
                             std::span<const Neighbour> ring) noexcept {
  return field.data() + (ring.data() - table.neighbour.data());
}

/// The positions of a ring's neighbours, read where they are stored.
template <Scalar S, std::size_t Valence>
struct RingPositions {
  std::span<const Neighbour, Valence> ring;
  std::span<const Vec3<S>> position;  // [particles]

  constexpr std::size_t size() const noexcept { return ring.size(); }
  const Vec3<S>& operator[](std::size_t j) const noexcept { return ring[j].in(position); }
};

/// Calls visit(ring, vertex, neighbours) for every ring.
template <class Visit>
void for_each_ring(const RingTable& table, Visit&& visit) noexcept {
  for_each_valence(table, [&]<std::size_t Valence>(const RingTable::Group& group) {
    for (int r = group.first; r < group.last; ++r) {
      const auto row = static_cast<std::size_t>(r);
      visit(row, static_cast<std::size_t>(table.vertex[row]), neighbours_of<Valence>(table, group, r));
    }
  });
}

}  // namespace trunk
