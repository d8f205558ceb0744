#pragma once

#include <unordered_set>
#include <vector>

#include "pml/physical_model.hpp"
#include "pml/xml_document.hpp"

/// Private to the pml layer: the components of a PML file.
namespace trunk::pml {

/// Throws InputError if there is a count nrOfStructures that is not a whole number.
void check_count(const XmlDocument& xml, pugi::xml_node parent);

/// Returns the attributes of the element `color`; none if there is no such element.
Attributes color(const XmlDocument& xml, pugi::xml_node parent);

/// Reads components after all atoms are known, and records the cells. All functions throw InputError.
class ComponentReader {
 public:
  ComponentReader(const XmlDocument& xml, const std::unordered_set<std::size_t>& atoms)
      : xml_(xml), atoms_(atoms) {}

  MultiComponent multi_component(pugi::xml_node node, int depth = 1);

  /// Checks all references to cells. Call it at the end, since a reference may stand before its cell.
  void check_cell_references() const;

 private:
  StructuralComponent structural_component(pugi::xml_node node);
  Cell cell(pugi::xml_node node);
  std::size_t cell_index(pugi::xml_node properties);
  void check_type(pugi::xml_node properties, const Cell& cell) const;
  std::size_t reference(pugi::xml_node node) const;
  std::size_t atom_reference(pugi::xml_node node) const;
  std::size_t cell_reference(pugi::xml_node node);

  const XmlDocument& xml_;
  const std::unordered_set<std::size_t>& atoms_;
  std::unordered_set<std::size_t> cells_;
  std::vector<pugi::xml_node> cell_references_;
};

}  // namespace trunk::pml
