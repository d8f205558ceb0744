#include "scenarios/build_trunk.hpp"

#include "dynamics/auto_time_step.hpp"

namespace trunk {

Trunk build_trunk(const ScenarioFile& file) {
  Trunk trunk = assemble_trunk(file);
  if (file.scenario.automatic_step)
    require_memory(file, trunk);
  else
    require_stable(file, trunk);
  return trunk;
}

Trunk assemble_trunk(const ScenarioFile& file) {
  try {
    return make_trunk(file.scenario);
  } catch (const InputError& error) {
    // Loads and rigid parts name their own lines.
    rethrow_at({file.scenario.mesh ? file.scenario.mesh_file : file.path}, error);
  }
}

void require_stable(const ScenarioFile& file, const Trunk& trunk) {
  try {
    require_stable(file.scenario, trunk);
  } catch (const InputError& error) {
    rethrow_at(file.where("time.dt_ms"), error);
  }
}

void require_memory(const ScenarioFile& file, const Trunk& trunk) {
  try {
    require_memory(file.scenario, trunk);
  } catch (const InputError& error) {
    rethrow_at(file.where("time.start"), error);
  }
}

Trunk build_timed_trunk(ScenarioFile& file, double stiffer) {
  Trunk trunk = build_trunk(file);
  choose_time_step(file, trunk, stiffer);
  return trunk;
}

void choose_time_step(ScenarioFile& file, const Trunk& trunk, double stiffer) {
  Scenario& s = file.scenario;
  if (!s.automatic_step) return;
  s.step_choice = auto_time_step(trunk.model, s.parameters, s.activation, s.time, stiffer);
  s.time = s.step_choice->grid;
  s.automatic_step = false;
}

}  // namespace trunk
