#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/scenario.hpp"

namespace trunk {

/// A trunk as a PML file has it: the mesh with its anatomy and the physics given for single particles, and
/// the components marked as rigid.
struct TrunkFile {
  TrunkMesh mesh;
  std::vector<RigidPart> rigid;
};

/// Reads a trunk from a PML text. Expected in it, by name:
///  - `abdomen` and `lung`, components of TRIANGLE cells, closed and outward;
///  - `muscle_lines`, POLY_LINE cells around the trunk, each from the costal insertion up to the border of
///  the
///    central tendon;
///  - a multiComponent `Regions` of components of atoms, and any number of landmarks, as in TrunkMesh;
///  - on the model: `unit` (mm, the default, or m), `fineness`; on atoms: `mass` (kg), `stiffness` (times
///    k_elasticity), `damping` (times the damping coefficient); on muscle_lines: `strength` (times k_muscle);
///    on any component of atoms: `rigid` ("fixed" or "free").
/// Throws InputError naming the file, the component or atom, what was found and what was expected.
TrunkFile read_trunk_pml(const std::filesystem::path& path);
TrunkFile trunk_of_pml(const std::string& text, const std::string& name);

/// The same trunk as a PML text that CamiTK opens, in mm, with all that `given` says and every digit of it.
std::string trunk_pml(const TrunkMesh& mesh, const TrunkMesh::Given& given,
                      const std::vector<RigidPart>& rigid, const std::string& title);

/// The trunk of a scenario, healthy: its paralysis, if any, stays with the scenario.
std::string trunk_pml(const Scenario& scenario);

}  // namespace trunk
