#include "scenarios/scenario_trunk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

/// Removes the trunk that was read, with its rigid parts.
void drop_mesh(ScenarioFile& file) {
  file.scenario.mesh.reset();
  std::erase_if(file.scenario.rigid, [&](const RigidPart& part) { return part.at == Place{file.mesh_read}; });
  file.mesh_read.clear();
}

bool has_number(const std::vector<double>& given) {
  return std::any_of(given.begin(), given.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

void adopt_trunk(TrunkFile trunk, ScenarioFile& file) {
  Scenario& scenario = file.scenario;
  file.mesh_read = scenario.mesh_file;
  for (RigidPart& part : trunk.rigid) part.at = {file.mesh_read};
  scenario.mesh = std::make_shared<const TrunkMesh>(std::move(trunk.mesh));
  for (RigidPart& part : trunk.rigid)
    if (std::none_of(scenario.rigid.begin(), scenario.rigid.end(),
                     [&](const RigidPart& own) { return own.region == part.region; }))
      scenario.rigid.push_back(std::move(part));
}

void read_named_trunk(ScenarioFile& file) {
  Scenario& s = file.scenario;
  if (s.mesh && file.mesh_read != s.mesh_file) drop_mesh(file);
  if (s.mesh_file.empty() || s.mesh) return;
  try {
    adopt_trunk(read_trunk_pml(s.mesh_file), file);
  } catch (const InputError& error) {
    rethrow_named_in(file.where("geometry.pml"), error);
  }
  file.inputs.push_back(s.mesh_file);
}

void require_effect(const Setting& setting, const Scenario& s) {
  if (!s.mesh) return;
  const TrunkMesh::Given& given = s.mesh->given;
  const bool geometry = setting.key.starts_with("geometry.") && setting.key != "geometry.pml";
  const bool mass = setting.key == "tissue.particle_mass_kg" && has_number(given.mass);
  const bool tendon = setting.key == "tissue.tendon_stiffness_factor" && has_number(given.stiffness);
  const bool damping = setting.key == "tissue.damping" && has_number(given.damping);
  if (geometry || mass || tendon || damping)
    throw InputError(setting.at, fmt::format("has no effect, since the trunk comes from {}", s.mesh_file),
                     "a key that this file does not determine", "remove the setting, or change the file");
}

}  // namespace trunk
