#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/scenario.hpp"

namespace trunk {

/// The trunk of a PML file: the mesh with its anatomy, the physics that is given for single particles, and
/// the components that are marked as rigid.
struct TrunkFile {
  TrunkMesh mesh;
  std::vector<RigidPart> rigid;
};

/// Reads a trunk from a PML file, or from its text. The file must have, by name:
///  - `abdomen` and `lung`: components of TRIANGLE cells that form closed surfaces and face outwards
///  - `muscle_lines`: POLY_LINE cells around the trunk, each from the costal insertion up to the border of
///    the central tendon
///  - `Regions`: a multiComponent with components of atoms
///
/// Other components of atoms are landmarks, as in TrunkMesh. These attributes are optional:
///  - of the model: `unit` (mm, which is the default, or m), `fineness`
///  - of an atom: `mass` (kg), `stiffness` (times k_elasticity), `damping` (times the damping coefficient)
///  - of muscle_lines: `strength` (times k_muscle)
///  - of a component of atoms: `rigid` ("fixed" or "free")
///
/// Throws InputError with the file and the component or atom.
TrunkFile read_trunk_pml(const std::filesystem::path& path);
TrunkFile trunk_of_pml(const std::string& text, const std::string& name);

/// Returns a trunk as a PML text in mm that CamiTK opens, with all values of `given` and all their digits.
std::string trunk_pml(const TrunkMesh& mesh, const TrunkMesh::Given& given,
                      const std::vector<RigidPart>& rigid, const std::string& title);

/// Returns the trunk of a scenario as PML, without its paralysis, which stays in the scenario.
std::string trunk_pml(const Scenario& scenario);

}  // namespace trunk
