#include "pml/write_pml.hpp"

#include <algorithm>
#include <numeric>

#include "errors/input_error.hpp"
#include "pml/read_pml.hpp"
#include "pml/xml_writer.hpp"

namespace trunk::pml {
namespace {

constexpr const char* written_pml = "PML to be written";

std::size_t cells_in(const StructuralComponent& structure) {
  return static_cast<std::size_t>(
      std::count_if(structure.items.begin(), structure.items.end(),
                    [](const auto& item) { return std::holds_alternative<Cell>(item); }));
}

std::size_t cells_in(const MultiComponent& component) {
  const auto add_cells = [](std::size_t sum, const auto& part) { return sum + cells_in(part); };
  return std::accumulate(
      component.structures.begin(), component.structures.end(),
      std::accumulate(component.components.begin(), component.components.end(), std::size_t{0}, add_cells),
      add_cells);
}

std::size_t parts_of(const MultiComponent& component) {
  return component.components.size() + component.structures.size();
}

void add_count(pugi::xml_node to, std::size_t count) {
  add_attribute(add(to, "nrOfStructures"), "value", std::to_string(count));
}

void add_color(pugi::xml_node to, const Attributes& color) {
  if (!color.empty()) add_attributes(add(to, "color"), color);
}

void add_reference(pugi::xml_node to, const char* element, std::size_t index) {
  add_attribute(add(to, element), "index", std::to_string(index));
}

void add_atom(pugi::xml_node to, const Atom& atom) {
  const pugi::xml_node properties = add(add(to, "atom"), "atomProperties");
  add_attributes(properties, {{"index", std::to_string(atom.index)},
                              {"x", shortest(atom.position.x())},
                              {"y", shortest(atom.position.y())},
                              {"z", shortest(atom.position.z())}});
  add_attributes(properties, atom.attributes);
}

void add_item(pugi::xml_node to, const AtomReference& reference) {
  add_reference(to, "atomRef", reference.index);
}

void add_item(pugi::xml_node to, const CellReference& reference) {
  add_reference(to, "cellRef", reference.index);
}

void add_item(pugi::xml_node to, const Cell& cell) {
  const pugi::xml_node element = add(to, "cell");
  const pugi::xml_node properties = add(element, "cellProperties");
  if (cell.index) add_attribute(properties, "index", std::to_string(*cell.index));
  add_attribute(properties, "type", cell.type);
  add_attributes(properties, cell.attributes);
  add_color(element, cell.color);
  add_count(element, cell.atoms.size());
  for (const std::size_t atom : cell.atoms) add_reference(element, "atomRef", atom);
}

void add_structure(pugi::xml_node to, const StructuralComponent& structure) {
  const pugi::xml_node element = add(to, "structuralComponent");
  add_attributes(element, structure.attributes);
  add_color(element, structure.color);
  add_count(element, structure.items.size());
  for (const auto& item : structure.items)
    std::visit([&](const auto& known) { add_item(element, known); }, item);
}

void add_component(pugi::xml_node to, const MultiComponent& component) {
  const pugi::xml_node element = add(to, "multiComponent");
  add_attributes(element, component.attributes);
  for (const MultiComponent& part : component.components) add_component(element, part);
  for (const StructuralComponent& part : component.structures) add_structure(element, part);
}

void add_atoms(pugi::xml_node to, const PhysicalModel& model) {
  const pugi::xml_node list = add(add(to, "atoms"), "structuralComponent");
  add_attributes(list, model.atom_list_attributes);
  add_color(list, model.atom_list_color);
  add_count(list, model.atoms.size());
  for (const Atom& atom : model.atoms) add_atom(list, atom);
}

void add_counts(pugi::xml_node to, const PhysicalModel& model) {
  const MultiComponent informative = model.informative.value_or(MultiComponent{});
  add_attributes(to, {{"nrOfAtoms", std::to_string(model.atoms.size())},
                      {"nrOfExclusiveComponents", std::to_string(parts_of(model.exclusive))},
                      {"nrOfInformativeComponents", std::to_string(parts_of(informative))},
                      {"nrOfCells", std::to_string(cells_in(model.exclusive) + cells_in(informative))}});
}

std::string text_of_model(const PhysicalModel& model) {
  pugi::xml_document document;
  declare(document);
  const pugi::xml_node root = add(document, "physicalModel");
  add_attributes(root, model.attributes);
  add_counts(root, model);
  add_atoms(root, model);
  add_component(add(root, "exclusiveComponents"), model.exclusive);
  if (model.informative) add_component(add(root, "informativeComponents"), *model.informative);
  return text_of(document);
}

}  // namespace

std::string write_pml(const PhysicalModel& model) {
  PhysicalModel kept = model;
  if (kept.informative && kept.informative->empty()) kept.informative.reset();
  std::string text = text_of_model(kept);
  if (read_pml(text, written_pml) != kept)
    throw InputError({written_pml}, "the model would read back changed",
                     "names, types and values that XML keeps",
                     "look for NUL characters and for attributes nrOfAtoms, nrOfCells");
  return text;
}

}  // namespace trunk::pml
