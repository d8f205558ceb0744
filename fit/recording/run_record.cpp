#include "recording/run_record.hpp"

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"
#include "io/trunk_pml.hpp"

namespace trunk {
namespace {

constexpr double ml = 1e-6, mm = 1e-3;

std::vector<double> flat(const std::vector<BreathRun::Frame>& frames,
                         std::vector<Vec3d> BreathRun::Frame::*member) {
  std::vector<double> numbers;
  for (const auto& frame : frames)
    for (const Vec3d& a : frame.*member) numbers.insert(numbers.end(), {a.x(), a.y(), a.z()});
  return numbers;
}

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
  for (const Fibre& f : trunk.model.fibres) t.fibres.push_back({f.insertion, f.origin});
  for (const auto& line : trunk.mesh.muscle_lines) t.muscle_lines.emplace_back(line.begin(), line.end());
  return t;
}

std::vector<double> scaled_by(double factor, std::vector<double> values) {
  for (double& v : values) v *= factor;
  return values;
}

}  // namespace

std::string scenario_text(const ScenarioFile& file) {
  std::string text = to_toml(file.scenario) + "\n# as given in " + file.path + ":\n# ";
  for (char c : file.text) {
    text += c;
    if (c == '\n') text += "# ";
  }
  return text + "\n";
}

std::vector<NamedValue> measures_of(const BreathSummary& run) {
  if (!run.summary.completed()) {  // half a breath has no measures
    BreathSummary unknown;
    unknown.summary.status = Summary::Status::completed;
    std::vector<NamedValue> values = measures_of(unknown);
    for (NamedValue& v : values) v.value = std::nan("");
    return values;
  }
  const Measures& m = run.measures;
  return {{"delta_v_ml", "ml", m.delta_v / ml},
          {"delta_v_percent", "percent", 100.0 * m.delta_v / m.end_expiratory_volume},
          {"end_expiratory_volume_ml", "ml", m.end_expiratory_volume / ml},
          {"end_inspiratory_volume_ml", "ml", m.end_inspiratory_volume / ml},
          {"delta_l_mm", "mm", m.delta_l / mm},
          {"delta_l_percent", "percent", 100.0 * m.delta_l_fraction},
          {"delta_h_mm", "mm", m.delta_h / mm},
          {"delta_r_mm", "mm", m.delta_r / mm},
          {"excursion_left_mm", "mm", m.excursion_left / mm},
          {"excursion_right_mm", "mm", m.excursion_right / mm},
          {"max_relative_volume_error", "1", run.max_relative_volume_error},
          {"flipped_triangles", "1", static_cast<double>(run.flipped_triangles)},
          {"abdominal_pressure_peak_cmH2O", "cmH2O", run.peak_pressure_Pa / Pa_per_cmH2O}};
}

std::vector<NamedValue> parameters_of(const Candidate& candidate) {
  Candidate c = candidate;
  std::vector<NamedValue> result;
  for (const FreeParameter& p : free_parameters())
    result.push_back({std::string(p.name), std::string(p.unit), p.field(c)});
  return result;
}

void adopt_parameters(const std::vector<NamedValue>& parameters, Scenario& scenario) {
  Candidate c{scenario.parameters, scenario.activation};
  for (const NamedValue& v : parameters) free_parameter(v.name).field(c) = v.value;
  scenario.parameters = c.parameters;
  scenario.activation = c.activation;
  const auto& a = c.activation;
  if (a.period_s == 0.0)
    scenario.time.duration_s =
        std::max(scenario.time.duration_s, a.onset_s + a.rise_s + a.fast_fall_s + a.slow_fall_s);
}

std::string status_word(Summary::Status status) {
  switch (status) {
    case Summary::Status::completed:
      return "completed";
    case Summary::Status::diverged:
      return "diverged";
    case Summary::Status::volume_lost:
      return "volume_lost";
    case Summary::Status::unset:
      break;
  }
  return "not_run";
}

RunRecord run_record(const ScenarioFile& file, const Trunk& trunk, const BreathRun& run,
                     const Target& measured, const Provenance& provenance) {
  RunRecord r;
  r.title = file.scenario.title;
  r.status = status_word(run.summary.status);
  r.message = run.summary.message;
  r.scenario_toml = scenario_text(file);
  if (file.scenario.mesh) r.trunk_pml = trunk_pml(file.scenario);
  r.parameters = parameters_of({file.scenario.parameters, file.scenario.activation});
  r.measures = measures_of(run);
  r.trajectory = trajectory_of(trunk, run, file.scenario.time.dt_s);
  r.curve_time_s = run.time_s;
  const auto dV = scaled_by(1.0 / ml, run.delta_v);
  r.curves = {{"dV_model", "ml", "lung volume above end-expiration, simulated", dV},
              {"activation", "1", "muscle activation A(t)", run.activation},
              {"abdominal_pressure", "cmH2O", "pressure in the abdominal compartment above rest",
               scaled_by(1.0 / Pa_per_cmH2O, run.pressure_Pa)}};
  if (measured.time_s.size() > 1) {
    Series observed{"dV_measured", "ml", "lung volume above end-expiration, measured, interpolated", {}};
    Series residual{"residual", "ml", "model minus measured", {}};
    const double spacing = measured.time_s[1] - measured.time_s[0];
    const Eigen::VectorXd at_times = sampled(measured.delta_v, spacing, run.time_s);
    for (std::size_t i = 0; i < dV.size(); ++i) {
      observed.values.push_back(at_times[static_cast<Eigen::Index>(i)] / ml);
      residual.values.push_back(dV[i] - observed.values.back());
    }
    r.curves.push_back(std::move(observed));
    r.curves.push_back(std::move(residual));
  }
  r.provenance = provenance;
  return r;
}

}  // namespace trunk
