#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/piecewise_linear.hpp"
#include "pml/attributes.hpp"

/// The content of an LML file: loads on the atoms and components of a PML file, over time.
namespace trunk::pml {

/// Atoms first to last by index, both included.
struct AtomRange {
  std::size_t first = 0, last = 0;
  bool operator==(const AtomRange&) const = default;
};

struct ComponentName {
  std::string name;
  bool operator==(const ComponentName&) const = default;
};

/// Written "*".
struct AllAtoms {
  bool operator==(const AllAtoms&) const = default;
};

using LoadTarget = std::variant<AtomRange, ComponentName, AllAtoms>;

/// What a load does along one axis.
struct Axis {
  enum class Kind {
    free,   ///< nothing; the attribute is absent
    fixed,  ///< holds it; "NULL"
    along   ///< acts, `factor` times the value of the moment
  };
  Kind kind = Kind::free;
  double factor = 0.0;  ///< 0 unless along
  bool operator==(const Axis&) const = default;
};

using Axes = std::array<Axis, 3>;  ///< x, y, z

/// Towards an atom, wherever it is at the moment.
struct Toward {
  std::size_t atom = 0;
  bool operator==(const Toward&) const = default;
};

struct Load {
  enum class Type { translation, force, pressure, rotation, acceleration };
  struct Event {
    double date = 0.0;   ///< s
    double value = 0.0;  ///< in `unit`
    bool operator==(const Event&) const = default;
  };

  Type type = Type::translation;
  std::vector<LoadTarget> targets;
  std::vector<Event> events;  ///< dates increase; linear between, 0 before the first, held after the last
  std::variant<Axes, Toward> direction;
  std::string unit;       ///< as written; empty when not named
  Attributes attributes;  ///< of the load, but its type
  std::size_t line = 0;   ///< where the file has it, for messages; 0 in memory

  /// All but the line.
  friend bool operator==(const Load& a, const Load& b) {
    return a.type == b.type && a.targets == b.targets && a.events == b.events && a.direction == b.direction &&
           a.unit == b.unit && a.attributes == b.attributes;
  }
};

struct Loads {
  Attributes attributes;
  std::vector<Load> loads;
  bool operator==(const Loads&) const = default;
};

/// Value over time, in s and in the unit of the load times `to_si`.
/// Throws InputError when the dates do not increase.
PiecewiseLinear course(const Load& load, double to_si);

/// The atoms a load names by index, each once, in the order of the text; names and "*" add none.
/// Throws InputError when an index is `end` or more: no range is longer than what is there.
std::vector<std::size_t> listed_indices(const Load& load, std::size_t end);

}  // namespace trunk::pml
