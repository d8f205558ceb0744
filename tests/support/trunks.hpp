#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "forces/shape_memory.hpp"
#include "math/units.hpp"
#include "scenarios/read_scenario.hpp"
#include "support/zoo.hpp"

namespace trunk::test {

inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

inline std::filesystem::path scenario_folder() {
  return std::filesystem::path(TRUNK_SOURCE_DIR) / "scenarios";
}

/// A scenario that ships, by name: "healthy".
inline Scenario shipped(const std::string& name) {
  return read_scenario(scenario_folder() / (name + ".toml")).scenario;
}

/// A shipped scenario on the trunk without a lung, one breath from rest: what tests of the mechanics take
/// apart.
inline Scenario without_lung(const std::string& name) {
  const Scenario base = shipped("healthy_no_lung");
  Scenario s = shipped(name);
  if (!s.lung_acts) return s;
  s.lung_acts = false;
  s.pleura = {};
  s.parameters = base.parameters;
  s.tissue.held_stiffness = base.tissue.held_stiffness;
  s.time.start = Start::rest;
  return s;
}

/// A shipped scenario with everything that a step can meet.
inline Scenario laden(const std::string& name) {
  Scenario scenario = without_lung(name);
  scenario.abdominal_volume = PiecewiseLinear({{0.0, 1.0}, {1.0, 1.01}}, 1.0);
  scenario.loads = {
      {RegionLoad::Kind::force, "abdominal_wall", {0, -1, 0}, {}, PiecewiseLinear({{0.0, 1.0}}), {"here"}},
      {RegionLoad::Kind::pressure, "abdominal_wall", {}, {}, PiecewiseLinear({{0.0, 100.0}}), {"here"}},
      {RegionLoad::Kind::displacement,
       "pelvis",
       {0, 0, 1},
       {0, 0, 1},
       PiecewiseLinear({{0.0, 0.0}, {1.0, 0.001}}),
       {"here"}}};
  scenario.tissue.membrane_stiffness = 10.0;
  scenario.tissue.rib_friction = 0.3;
  RigidPart half{"rib_cage_right", RigidBody::Motion::driven, {}, "", {"here"}};
  half.imposed = {{0, 0, 0.5}, {0, -1, 0}, PiecewiseLinear({{0.0, 0.0}, {1.0, 0.02}}), {}, {}};
  scenario.rigid = {half, {"dome_top_left", RigidBody::Motion::free, {}, "", {"here"}}};
  return scenario;
}

/// The same trunk as a sheet.
inline Scenario on_sheet(Scenario scenario) {
  scenario.tissue.elasticity = ElasticLaw::sheet;
  return scenario;
}

/// A scenario with the lung of a healthy adult and a stiff airway: 5 cmH2O/L and 2.75 cmH2O s/L.
inline Scenario with_lung(Scenario scenario) {
  scenario.lung_acts = true;
  scenario.parameters.lung_elastance = 5.0 * Pa_per_cmH2O / m3_per_litre;
  scenario.parameters.resistance = 2.75 * Pa_per_cmH2O / m3_per_litre;
  return scenario;
}

/// The quiet breath of a healthy adult with a lung: 466 ml every 4.5 s.
inline Scenario breathing_air() {
  Scenario s = shipped("healthy");
  s.time.damping = Damping::centred;
  return s;
}

/// A laden scenario with a lung and a tube at a pressure that changes. A lung acts on no free part.
inline Scenario laden_with_lung(const std::string& name) {
  Scenario s = with_lung(laden(name));
  s.rigid.pop_back();
  s.pleura.airway_pressure = PiecewiseLinear({{0.0, 200.0}, {0.1, 900.0}, {0.3, -300.0}});
  s.pleura.tube_resistance = 4e5;
  return s;
}

/// The breath of a shipped scenario without a lung, no frames kept.
inline BreathRun breath_of(const std::string& name) {
  const Scenario scenario = without_lung(name);
  return run_breath(make_trunk(scenario), scenario, 0);
}

/// A body of elastic particles that nothing holds: no supports, fibres, loads or volume to keep.
inline Model free_body(const Mesh& mesh, Reaction reaction, double mass) {
  const std::size_t n = mesh.position.size();
  Model model;
  model.rest = mesh.position;
  model.mass.assign(n, mass);
  model.damping_weight.assign(n, 1.0);
  model.mobility.assign(n, {1.0, 1.0, 1.0});
  const std::vector<double> one(n, 1.0), none(n, 0.0);
  model.shape_memory = make_shape_memory(mesh.surface(), mesh.position, one, none, reaction);
  model.lung = mesh.triangles;
  model.lung_fans = fans(mesh.triangles);
  return model;
}

/// Adds a volume to hold to a body made of that mesh.
inline void hold_volume(const Mesh& mesh, Model& model) {
  model.abdomen = held_volume(mesh.surface(), mesh.position);
}

/// How far outside of its support's surface a particle is, m (to second order); negative inside.
inline double outside(const Model& model, const State<double>& state, const std::vector<Vec3d>& position,
                      const Support& s) {
  const auto b = static_cast<std::size_t>(s.body);
  const Pose<double>& pose = state.body[b].pose;
  const Vec3d point = placed(model.bodies[b], pose, s.point);
  const Vec3d y = turn_back(pose.rotation, position[static_cast<std::size_t>(s.particle)] - point);
  const Vec3d bend{dot(s.curvature[0], y), dot(s.curvature[1], y), dot(s.curvature[2], y)};
  return dot(s.normal, y) + 0.5 * dot(bend, y);
}

inline Vec3d total(const std::vector<Vec3d>& field) {
  Vec3d sum;
  for (const Vec3d& a : field) sum += a;
  return sum;
}

/// Sum of position x force (or momentum).
inline Vec3d total_moment(const std::vector<Vec3d>& position, const std::vector<Vec3d>& field) {
  Vec3d sum;
  for (std::size_t i = 0; i < field.size(); ++i) sum += cross(position[i], field[i]);
  return sum;
}

inline double largest(const std::vector<Vec3d>& field) {
  double most = 0.0;
  for (const Vec3d& a : field) most = std::max(most, norm(a));
  return most;
}

inline std::vector<Vec3d> difference(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
  std::vector<Vec3d> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

}  // namespace trunk::test
