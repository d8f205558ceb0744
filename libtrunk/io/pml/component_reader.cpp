#include "pml/component_reader.hpp"

#include <fmt/format.h>

#include "pml/cell_types.hpp"
#include "text/message_text.hpp"

namespace trunk::pml {
namespace {

constexpr int deepest_nesting = 64;

}  // namespace

void check_count(const XmlDocument& xml, pugi::xml_node parent) {
  if (const pugi::xml_node count = xml.at_most_one(parent, "nrOfStructures")) {
    xml.allow_elements(count, {});
    xml.allow_attributes(count, {"value"});
    xml.index(count, "value");
  }
}

Attributes color(const XmlDocument& xml, pugi::xml_node parent) {
  const pugi::xml_node node = xml.at_most_one(parent, "color");
  xml.allow_elements(node, {});
  return xml.attributes(node);
}

MultiComponent ComponentReader::multi_component(pugi::xml_node node, int depth) {
  if (depth > deepest_nesting)
    xml_.fail(node, fmt::format("multiComponent at depth {}", depth),
              fmt::format("at most {}", deepest_nesting), "flatten the tree");
  xml_.allow_elements(node, {"multiComponent", "structuralComponent"});
  MultiComponent component;
  component.attributes = xml_.attributes(node);
  for (const pugi::xml_node child : node.children("multiComponent"))
    component.components.push_back(multi_component(child, depth + 1));
  for (const pugi::xml_node child : node.children("structuralComponent"))
    component.structures.push_back(structural_component(child));
  return component;
}

StructuralComponent ComponentReader::structural_component(pugi::xml_node node) {
  xml_.allow_elements(node, {"color", "nrOfStructures", "atomRef", "cellRef", "cell"});
  check_count(xml_, node);
  StructuralComponent component{xml_.attributes(node), color(xml_, node), {}};
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (name == "atomRef") component.items.push_back(AtomReference{atom_reference(child)});
    if (name == "cellRef") component.items.push_back(CellReference{cell_reference(child)});
    if (name == "cell") component.items.push_back(cell(child));
  }
  return component;
}

Cell ComponentReader::cell(pugi::xml_node node) {
  xml_.allow_attributes(node, {});
  xml_.allow_elements(node, {"cellProperties", "color", "nrOfStructures", "atomRef"});
  check_count(xml_, node);
  const pugi::xml_node properties = xml_.only(node, "cellProperties");
  xml_.allow_elements(properties, {});
  Cell cell;
  cell.type = xml_.value(properties, "type");
  cell.attributes = xml_.attributes(properties, {"index", "type"});
  cell.color = color(xml_, node);
  if (properties.attribute("index")) cell.index = cell_index(properties);
  for (const pugi::xml_node child : node.children("atomRef")) cell.atoms.push_back(atom_reference(child));
  check_type(properties, cell);
  return cell;
}

std::size_t ComponentReader::cell_index(pugi::xml_node properties) {
  const std::size_t index = xml_.index(properties, "index");
  if (!cells_.insert(index).second)
    xml_.fail(properties, fmt::format("a second cell of index {}", index), "every index once", "renumber it");
  return index;
}

void ComponentReader::check_type(pugi::xml_node properties, const Cell& cell) const {
  const CellType* const type = find_cell_type(cell.type);
  if (!type) {
    std::vector<std::string_view> names;
    for (const CellType& known : cell_types) names.push_back(known.name);
    xml_.fail(properties, fmt::format("cell of unknown type {}", excerpt(cell.type)),
              fmt::format("{}", fmt::join(names, ", ")), "correct it");
  }
  if (cell.atoms.size() < type->least_atoms || cell.atoms.size() > type->most_atoms)
    xml_.fail(properties, fmt::format("{} of {} atoms", cell.type, cell.atoms.size()),
              fmt::format("{}{}", type->most_atoms == any_number ? "at least " : "", type->least_atoms),
              "correct its atomRefs or its type");
}

std::size_t ComponentReader::reference(pugi::xml_node node) const {
  xml_.allow_attributes(node, {"index"});
  xml_.allow_elements(node, {});
  return xml_.index(node, "index");
}

std::size_t ComponentReader::atom_reference(pugi::xml_node node) const {
  const std::size_t index = reference(node);
  if (!atoms_.contains(index))
    xml_.fail(node, fmt::format("atomRef to {}", index), "the index of an atom",
              "add the atom or remove this");
  return index;
}

std::size_t ComponentReader::cell_reference(pugi::xml_node node) {
  cell_references_.push_back(node);
  return reference(node);
}

void ComponentReader::check_cell_references() const {
  for (const pugi::xml_node node : cell_references_)
    if (const std::size_t index = reference(node); !cells_.contains(index))
      xml_.fail(node, fmt::format("cellRef to {}", index), "the index of a cell",
                "add the cell or remove this");
}

}  // namespace trunk::pml
