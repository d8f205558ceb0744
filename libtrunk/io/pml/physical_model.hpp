#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "math/vec3.hpp"
#include "pml/attributes.hpp"

/// The content of a PML file, element for element and without comments. The physics is in free attributes
/// ("mass", "stiffness", "incompressibility"), which are texts here.
namespace trunk::pml {

struct Atom {
  std::size_t index = 0;  ///< unique in the model, not necessarily contiguous
  Vec3d position;         ///< in the unit of the file; PML names no unit, CamiTK uses mm
  Attributes attributes;  ///< of atomProperties, without index, x, y, z

  friend bool operator==(const Atom& a, const Atom& b) {
    const auto key = [](const Atom& atom) {
      return std::tuple(atom.index, atom.position.x(), atom.position.y(), atom.position.z());
    };
    return key(a) == key(b) && a.attributes == b.attributes;
  }
};

struct Cell {
  std::optional<std::size_t> index;  ///< unique in the model
  std::string type;                  ///< one of cell_types
  Attributes attributes;             ///< of cellProperties, without index and type
  Attributes color;                  ///< r, g, b, a; empty without colour
  std::vector<std::size_t> atoms;    ///< atom indexes, in the order of the type

  bool operator==(const Cell&) const = default;
};

struct AtomReference {
  std::size_t index = 0;
  bool operator==(const AtomReference&) const = default;
};

struct CellReference {
  std::size_t index = 0;
  bool operator==(const CellReference&) const = default;
};

/// A named part of the model: indexes of atoms, cells, and indexes of cells.
struct StructuralComponent {
  Attributes attributes;
  Attributes color;  ///< r, g, b, a; empty without colour
  std::vector<std::variant<AtomReference, Cell, CellReference>> items;

  bool operator==(const StructuralComponent&) const = default;
};

/// A group of parts. The writer puts `components` before `structures`.
struct MultiComponent {
  Attributes attributes;
  std::vector<MultiComponent> components;
  std::vector<StructuralComponent> structures;

  bool empty() const noexcept { return components.empty() && structures.empty(); }
  bool operator==(const MultiComponent&) const = default;
};

struct PhysicalModel {
  Attributes attributes;            ///< without the four counts nrOf…, which the writer computes
  Attributes atom_list_attributes;  ///< of the component that lists the atoms
  Attributes atom_list_color;
  std::vector<Atom> atoms;
  MultiComponent exclusive;
  std::optional<MultiComponent> informative;  ///< never empty in a file

  bool operator==(const PhysicalModel&) const = default;
};

}  // namespace trunk::pml
