#include <fmt/format.h>

#include <cmath>

#include "math/units.hpp"
#include "pml/write_pml.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {
namespace {

std::string digits(double value) {
  return fmt::format("{}", value);
}

std::vector<pml::Atom> atoms_of(const TrunkMesh& mesh, const TrunkMesh::Given& given) {
  std::vector<pml::Atom> atoms;
  for (std::size_t i = 0; i < mesh.rest.size(); ++i) {
    atoms.push_back({i, mm_per_m * mesh.rest[i], {}});
    for (const auto& [name, field] :
         {std::pair{"mass", &given.mass}, std::pair{"stiffness", &given.stiffness},
          std::pair{"damping", &given.damping}})
      if (i < field->size() && std::isfinite((*field)[i]))
        atoms.back().attributes.push_back({name, digits((*field)[i])});
  }
  return atoms;
}

template <class Indices>
pml::Cell cell_of(const char* type, const Indices& indices) {
  return {{}, type, {}, {}, {indices.begin(), indices.end()}};
}

pml::StructuralComponent surface_of(const char* name, const std::vector<Triangle>& triangles,
                                    bool volume_held) {
  pml::StructuralComponent component{{{"name", name}, {"mode", "WIREFRAME_AND_SURFACE"}}, {}, {}};
  if (volume_held) component.attributes.push_back({"incompressibility", "true"});
  for (const Triangle& t : triangles) component.items.push_back(cell_of("TRIANGLE", t));
  return component;
}

/// Returns the neighbours of each particle of the elastic surface, as models of CamiTK list them.
pml::StructuralComponent neighbourhoods_of(const TrunkMesh& mesh) {
  pml::StructuralComponent component{{{"name", "Node Neighborhoods"}}, {}, {}};
  const Surface abdomen("abdomen", mesh.abdomen, static_cast<int>(mesh.rest.size()));
  for (const Surface::OneRing& ring : abdomen.one_rings()) {
    pml::Cell cell = cell_of("POLY_VERTEX", ring.neighbours);
    cell.attributes.push_back({"name", fmt::format("Atom #{}", ring.vertex)});
    component.items.push_back(std::move(cell));
  }
  return component;
}

pml::StructuralComponent muscle_lines_of(const TrunkMesh& mesh, double strength) {
  pml::StructuralComponent component{{{"name", "muscle_lines"}}, {}, {}};
  if (strength > 0.0) component.attributes.push_back({"strength", digits(strength)});
  for (const auto& line : mesh.muscle_lines) component.items.push_back(cell_of("POLY_LINE", line));
  return component;
}

pml::StructuralComponent named(const std::string& name, const std::vector<int>& particles,
                               const std::vector<RigidPart>& rigid) {
  pml::StructuralComponent component{{{"name", name}}, {}, {}};
  if (name == "fixed") component.attributes.push_back({"fixed", "true"});
  for (const RigidPart& part : rigid)
    if (part.region == name && part.motion != RigidBody::Motion::driven) {
      component.attributes.push_back({"rigid", part.motion == RigidBody::Motion::free ? "free" : "fixed"});
      if (!part.surface_for.empty()) component.attributes.push_back({"surfaceFor", part.surface_for});
    }
  for (int i : particles) component.items.push_back(pml::AtomReference{static_cast<std::size_t>(i)});
  return component;
}

}  // namespace

std::string trunk_pml(const TrunkMesh& mesh, const TrunkMesh::Given& given,
                      const std::vector<RigidPart>& rigid, const std::string& title) {
  pml::PhysicalModel model;
  model.attributes = {{"name", title}, {"unit", "mm"}, {"axes", "RAS"}, {"fineness", digits(mesh.fineness)}};
  model.atom_list_attributes = {{"name", "particles"}};
  model.atoms = atoms_of(mesh, given);

  pml::MultiComponent volumes{{{"name", "Enclosed Volumes"}}, {}, {}};
  volumes.structures = {surface_of("abdomen", mesh.abdomen, true), surface_of("lung", mesh.lung, false)};
  pml::MultiComponent regions{{{"name", "Regions"}}, {}, {}};
  for (const auto& [name, particles] : mesh.regions)
    regions.structures.push_back(named(name, particles, rigid));
  model.exclusive = {{{"name", "Exclusive Components"}}, {volumes, regions}, {neighbourhoods_of(mesh)}};

  pml::MultiComponent informative{{{"name", "Informative Components"}}, {}, {}};
  informative.structures.push_back(muscle_lines_of(mesh, given.fibre_strength));
  for (const auto& [name, particles] : mesh.landmarks)
    informative.structures.push_back(named(name, particles, rigid));
  model.informative = std::move(informative);
  return pml::write_pml(model);
}

std::string trunk_pml(const Scenario& scenario) {
  const TrunkMesh mesh = mesh_of(scenario);
  return trunk_pml(mesh, healthy_tissue(mesh, scenario.tissue), scenario.rigid, scenario.title);
}

}  // namespace trunk
