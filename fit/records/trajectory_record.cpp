#include "records/trajectory_record.hpp"

namespace trunk {
namespace {

std::vector<double> flat(const std::vector<BreathRun::Frame>& frames,
                         std::vector<Vec3d> BreathRun::Frame::*member) {
  std::vector<double> numbers;
  for (const auto& frame : frames)
    for (const Vec3d& a : frame.*member) numbers.insert(numbers.end(), {a.x(), a.y(), a.z()});
  return numbers;
}

void add_contact(const Trunk& trunk, const BreathRun& run, Trajectory& t) {
  if (trunk.model.supports.empty()) return;
  t.contact_names = {"none", "slides", "sticks"};
  for (const auto& frame : run.frames) {
    const std::size_t first = t.contact.size();
    t.contact.resize(first + t.particles, 0);
    for (std::size_t s = 0; s < frame.touch.size(); ++s)
      t.contact[first + static_cast<std::size_t>(trunk.model.supports[s].particle)] =
          static_cast<std::int32_t>(frame.touch[s]);
  }
}

}  // namespace

Trajectory trajectory_of(const Trunk& trunk, const BreathRun& run, double dt_s) {
  Trajectory t;
  t.particles = trunk.model.particles();
  for (const auto& frame : run.frames) {
    t.step.push_back(frame.step);
    t.time_s.push_back(frame.step * dt_s);
  }
  t.position_m = flat(run.frames, &BreathRun::Frame::position);
  t.velocity_m_s = flat(run.frames, &BreathRun::Frame::velocity);
  t.mass_kg = trunk.model.mass;
  t.region.assign(t.particles, 0);
  for (const auto& [name, particles] : trunk.mesh.regions) {
    for (int i : particles)
      t.region[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(t.region_names.size());
    t.region_names.push_back(name);
  }
  t.rigid.assign(t.particles, 0);
  t.rigid_names = {"none"};
  for (const RigidBody& body : trunk.model.bodies) {
    for (int i : body.particles)
      t.rigid[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(t.rigid_names.size());
    t.rigid_names.push_back(body.name);
  }
  t.component_names = {"abdomen_and_diaphragm", "lung"};
  for (const auto& [triangles, component] :
       {std::pair{&trunk.mesh.abdomen, 0}, std::pair{&trunk.mesh.lung, 1}})
    for (const auto& [i, j, k] : *triangles) {
      t.triangles.push_back({i, j, k});
      t.triangle_component.push_back(component);
    }
  for (const Fibre& f : trunk.model.fibres) {
    t.fibres.push_back({f.insertion, f.origin});
    t.fibre_activity.push_back(f.activity);
  }
  for (const auto& line : trunk.mesh.muscle_lines) t.muscle_lines.emplace_back(line.begin(), line.end());
  add_contact(trunk, run, t);
  return t;
}

}  // namespace trunk
