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

/// The atoms from index `first` to index `last`, both included.
struct AtomRange {
  std::size_t first = 0, last = 0;
  bool operator==(const AtomRange&) const = default;
};

struct ComponentName {
  std::string name;
  bool operator==(const ComponentName&) const = default;
};

/// All atoms, written "*".
struct AllAtoms {
  bool operator==(const AllAtoms&) const = default;
};

/// What one item of appliedTo names.
using LoadTarget = std::variant<AtomRange, ComponentName, AllAtoms>;

/// Returns load targets as the text of appliedTo: "0-3,7,left lung" or "*".
std::string text_of(const std::vector<LoadTarget>& targets);

/// What a load does along one axis.
struct Axis {
  enum class Kind {
    free,   ///< does nothing; the attribute is absent
    fixed,  ///< holds the atoms; the attribute is "NULL"
    along   ///< acts with `factor` times the value of the moment
  };
  Kind kind = Kind::free;
  double factor = 0.0;  ///< 0 unless along
  bool operator==(const Axis&) const = default;
};

using Axes = std::array<Axis, 3>;  ///< x, y, z

/// A direction towards the present position of an atom.
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
  std::vector<Event>
      events;  ///< by increasing date; linear between dates, 0 before the first, constant after the last
  std::variant<Axes, Toward> direction;
  std::string unit;       ///< as written; empty if the file names none
  Attributes attributes;  ///< of the load, without its type
  std::size_t line = 0;   ///< of the load in the file, for messages; 0 if it is from no file

  /// Compares all members except the line.
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

/// Returns the value of a load times `to_si` over time in s; throws InputError if the dates do not increase.
PiecewiseLinear course(const Load& load, double to_si);

/// Returns the atoms that a load names by index, each once, in the order of the text. Names and "*" add none.
/// Throws InputError if an index is `end` or more, so that no range is longer than the model.
std::vector<std::size_t> listed_indices(const Load& load, std::size_t end);

}  // namespace trunk::pml
