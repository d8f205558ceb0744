#include <fmt/format.h>

#include <unordered_map>

#include "pml/read_pml.hpp"
#include "surfaces/formats/raw_surface.hpp"

namespace trunk {
namespace {

using Cells = std::unordered_map<std::size_t, const pml::Cell*>;

template <class Visit>
void visit_structures(const pml::MultiComponent& parent, const Visit& visit) {
  for (const pml::StructuralComponent& structure : parent.structures) visit(structure);
  for (const pml::MultiComponent& child : parent.components) visit_structures(child, visit);
}

template <class Visit>
void visit_structures(const pml::PhysicalModel& model, const Visit& visit) {
  visit_structures(model.exclusive, visit);
  if (model.informative) visit_structures(*model.informative, visit);
}

const pml::Cell* cell_of(const std::variant<pml::AtomReference, pml::Cell, pml::CellReference>& item,
                         const Cells& cells) {
  if (const auto* cell = std::get_if<pml::Cell>(&item)) return cell;
  if (const auto* reference = std::get_if<pml::CellReference>(&item)) {
    const auto known = cells.find(reference->index);
    return known == cells.end() ? nullptr : known->second;
  }
  return nullptr;
}

}  // namespace

/// Every component of TRIANGLE or QUAD cells is a part. Cells that a second component only refers to are
/// there twice: the repair drops them.
RawSurface read_pml_surface(const std::string& bytes, const std::string& file) {
  const pml::PhysicalModel model = pml::read_pml(bytes, file);
  SurfaceBuilder builder(file, "PML");
  if (const std::string* unit = pml::find(model.attributes, "unit")) builder.unit(*unit);
  std::unordered_map<std::size_t, double> point_of;
  for (const pml::Atom& atom : model.atoms) {
    point_of[atom.index] = static_cast<double>(builder.points());
    builder.point(atom.position);
  }
  Cells cells;
  visit_structures(model, [&](const pml::StructuralComponent& structure) {
    for (const auto& item : structure.items)
      if (const auto* cell = std::get_if<pml::Cell>(&item); cell && cell->index) cells[*cell->index] = cell;
  });
  visit_structures(model, [&](const pml::StructuralComponent& structure) {
    const std::string* name = pml::find(structure.attributes, "name");
    builder.begin_part(name ? *name : "");
    for (const auto& item : structure.items) {
      const pml::Cell* cell = cell_of(item, cells);
      if (!cell || (cell->type != "TRIANGLE" && cell->type != "QUAD")) continue;
      std::vector<double> corners;
      for (const std::size_t atom : cell->atoms) corners.push_back(point_of.at(atom));
      builder.polygon(corners);
    }
  });
  RawSurface surface = builder.finish();
  if (const std::string* axes = pml::find(model.attributes, "axes")) surface.axes = *axes;
  return surface;
}

}  // namespace trunk
