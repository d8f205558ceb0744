#include "pml/read_pml.hpp"

#include <fmt/format.h>

#include <unordered_set>

#include "pml/component_reader.hpp"

namespace trunk::pml {
namespace {

class PmlReader {
 public:
  PmlReader(std::string_view text, const std::string& file) : xml_(text, file, "PML") {}

  PhysicalModel model() {
    const pugi::xml_node root = xml_.root();
    if (root.name() != std::string_view("physicalModel"))
      xml_.fail(root, fmt::format("<{}> found", root.name()), "<physicalModel>", "give a PML file");
    xml_.allow_elements(root, {"atoms", "exclusiveComponents", "informativeComponents"});

    PhysicalModel model;
    model.attributes = xml_.attributes(
        root, {"nrOfAtoms", "nrOfExclusiveComponents", "nrOfInformativeComponents", "nrOfCells"});
    read_atoms(xml_.only(root, "atoms"), model);
    model.exclusive = exclusive(xml_.only(root, "exclusiveComponents"));
    model.informative = informative(xml_.at_most_one(root, "informativeComponents"));
    components_.check_cell_references();
    return model;
  }

 private:
  void read_atoms(pugi::xml_node atoms, PhysicalModel& model) {
    xml_.allow_attributes(atoms, {});
    xml_.allow_elements(atoms, {"structuralComponent"});
    const pugi::xml_node list = xml_.only(atoms, "structuralComponent");
    xml_.allow_elements(list, {"color", "nrOfStructures", "atom"});
    check_count(xml_, list);
    model.atom_list_attributes = xml_.attributes(list);
    model.atom_list_color = color(xml_, list);
    for (const pugi::xml_node node : list.children("atom")) model.atoms.push_back(atom(node));
  }

  Atom atom(pugi::xml_node node) {
    xml_.allow_attributes(node, {});
    xml_.allow_elements(node, {"atomProperties"});
    const pugi::xml_node properties = xml_.only(node, "atomProperties");
    xml_.allow_elements(properties, {});
    const std::size_t index = xml_.index(properties, "index");
    if (!atoms_.insert(index).second)
      xml_.fail(properties, fmt::format("a second atom of index {}", index), "every index once",
                "renumber it");
    return {index,
            {xml_.number(properties, "x"), xml_.number(properties, "y"), xml_.number(properties, "z")},
            xml_.attributes(properties, {"index", "x", "y", "z"})};
  }

  MultiComponent exclusive(pugi::xml_node node) {
    xml_.allow_attributes(node, {});
    xml_.allow_elements(node, {"multiComponent"});
    return components_.multi_component(xml_.only(node, "multiComponent"));
  }

  // Some programs write the element without content if there is nothing.
  std::optional<MultiComponent> informative(pugi::xml_node node) {
    xml_.allow_attributes(node, {});
    xml_.allow_elements(node, {"multiComponent"});
    const pugi::xml_node content = xml_.at_most_one(node, "multiComponent");
    if (!content) return std::nullopt;
    MultiComponent component = components_.multi_component(content);
    if (component.empty())
      xml_.fail(content, "informative multiComponent with nothing in it", "components", "remove it");
    return component;
  }

  XmlDocument xml_;
  std::unordered_set<std::size_t> atoms_;
  ComponentReader components_{xml_, atoms_};
};

}  // namespace

PhysicalModel read_pml(std::string_view text, const std::string& file) {
  return PmlReader(text, file).model();
}

}  // namespace trunk::pml
