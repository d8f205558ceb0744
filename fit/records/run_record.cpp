#include "records/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"
#include "records/trajectory_record.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {
namespace {

using Steps = std::vector<std::size_t>;

std::vector<double> at_steps(const Steps& steps, const std::vector<double>& values, double unit) {
  std::vector<double> some;
  for (const std::size_t step : steps) some.push_back(values[step] / unit);
  return some;
}

/// Returns the simulated curves at those steps; `volume` is the name of the volume.
std::vector<Series> own_series(const BreathRun& run, const Steps& steps, const std::string& volume) {
  std::vector<Series> series = {
      {volume, "ml", "lung volume above end-expiration, simulated", at_steps(steps, run.delta_v, m3_per_ml)},
      {"activation", "1", "muscle activation A(t)", at_steps(steps, run.activation, 1.0)},
      {"abdominal_pressure", "cmH2O", "pressure in the abdominal compartment above rest",
       at_steps(steps, run.pressure_Pa, Pa_per_cmH2O)}};
  if (!run.pleural_pressure_Pa.empty())
    series.push_back({"pleural_pressure", "cmH2O", "pleural pressure above rest",
                      at_steps(steps, run.pleural_pressure_Pa, Pa_per_cmH2O)});
  return series;
}

/// Returns volume, activation, pressure, the lengths of Table 1 and the descent of the domes at each frame.
std::vector<Series> frame_series(const Trunk& trunk, const BreathRun& run) {
  Steps steps;
  for (const auto& frame : run.frames) steps.push_back(static_cast<std::size_t>(frame.step));
  std::vector<Series> all = own_series(run, steps, "dV");
  const Shape start = shape_of(trunk, run.start);
  std::vector<Measures> measures;
  for (const auto& frame : run.frames)
    measures.push_back(measures_between(start, shape_of(trunk, frame.position)));
  const auto add = [&](const char* name, const char* meaning, double Measures::*member) {
    Series series{name, "mm", meaning, {}};
    for (const Measures& m : measures) series.values.push_back(m.*member / m_per_mm);
    all.push_back(std::move(series));
  };
  add("dL", "shortening of the zone of apposition", &Measures::delta_l);
  add("dH", "flattening of the domes", &Measures::delta_h);
  add("dR", "widening of the zone of apposition", &Measures::delta_r);
  add("excursion_right", "descent of the right dome", &Measures::excursion_right);
  add("excursion_left", "descent of the left dome", &Measures::excursion_left);
  return all;
}

/// Returns every step, or one step every 10 ms if no trajectory is kept.
Steps curve_steps(const BreathRun& run, const Scenario& scenario) {
  const long every = run.frames.empty() ? std::lround(0.01 / scenario.time.dt_s) : 1;
  Steps steps;
  for (std::size_t step = 0; step < run.time_s.size(); step += static_cast<std::size_t>(std::max(1L, every)))
    steps.push_back(step);
  return steps;
}

void add_curves(const BreathRun& run, const Steps& steps, const MeasuredCurve& measured, RunRecord& r) {
  r.curve_time_s = at_steps(steps, run.time_s, 1.0);
  r.curves = own_series(run, steps, "dV_model");
  if (measured.time_s.size() <= 1) return;
  Series observed{"dV_measured", "ml", "lung volume above end-expiration, measured, interpolated", {}};
  Series residual{"residual", "ml", "model minus measured", {}};
  const double spacing = measured.time_s[1] - measured.time_s[0];
  const Eigen::VectorXd at_times = sampled(measured.delta_v, spacing, r.curve_time_s);
  for (std::size_t i = 0; i < r.curve_time_s.size(); ++i) {
    observed.values.push_back(at_times[static_cast<Eigen::Index>(i)] / m3_per_ml);
    residual.values.push_back(r.curves.front().values[i] - observed.values.back());
  }
  r.curves.push_back(std::move(observed));
  r.curves.push_back(std::move(residual));
}

}  // namespace

std::string scenario_text(const ScenarioFile& file) {
  std::string text = to_toml(file.scenario);
  if (const auto& c = file.scenario.step_choice)
    text += fmt::format(
        "\n# time.dt_ms = \"auto\" chose {:g} ms: stable below {:.3g} ms, lung volume within {:.2g} % of "
        "short steps\n",
        ms_per_s * c->grid.dt_s, ms_per_s * c->stable_s, 100.0 * c->estimated_error);
  text += "\n# as given in " + file.path + ":\n# ";
  for (char c : file.text) {
    text += c;
    if (c == '\n') text += "# ";
  }
  return text + "\n";
}

std::vector<NamedValue> measures_of(const BreathSummary& run) {
  if (!run.ending.completed()) {
    BreathSummary unknown;
    unknown.ending.status = Ending::Status::completed;
    unknown.swings = run.swings;
    std::vector<NamedValue> values = measures_of(unknown);
    for (NamedValue& v : values) v.value = std::nan("");
    return values;
  }
  const Measures& m = run.measures;
  std::vector<NamedValue> values = {
      {"delta_v_ml", "ml", m.delta_v / m3_per_ml},
      {"delta_v_percent", "percent", 100.0 * m.delta_v / m.end_expiratory_volume},
      {"end_expiratory_volume_ml", "ml", m.end_expiratory_volume / m3_per_ml},
      {"end_inspiratory_volume_ml", "ml", m.end_inspiratory_volume / m3_per_ml},
      {"delta_l_mm", "mm", m.delta_l / m_per_mm},
      {"delta_l_percent", "percent", 100.0 * m.delta_l_fraction},
      {"delta_h_mm", "mm", m.delta_h / m_per_mm},
      {"delta_r_mm", "mm", m.delta_r / m_per_mm},
      {"excursion_left_mm", "mm", m.excursion_left / m_per_mm},
      {"excursion_right_mm", "mm", m.excursion_right / m_per_mm},
      {"max_relative_volume_error", "1", run.max_relative_volume_error},
      {"flipped_triangles", "1", static_cast<double>(run.flipped_triangles)},
      {"abdominal_pressure_peak_cmH2O", "cmH2O", run.peak_pressure_Pa / Pa_per_cmH2O},
      {"end_expiratory_above_relaxation_ml", "ml", run.above_relaxation / m3_per_ml},
      {"gastric_swing_cmH2O", "cmH2O", run.gastric_swing_Pa / Pa_per_cmH2O},
      {"excursion_left_most_risen_mm", "mm", 0.0 - run.left_rise / m_per_mm},
      {"excursion_right_most_risen_mm", "mm", 0.0 - run.right_rise / m_per_mm}};
  if (!run.swings) return values;
  values.push_back({"pleural_swing_cmH2O", "cmH2O", run.swings->pleural_Pa / Pa_per_cmH2O});
  values.push_back(
      {"transdiaphragmatic_swing_cmH2O", "cmH2O", run.swings->transdiaphragmatic_Pa / Pa_per_cmH2O});
  return values;
}

std::vector<NamedValue> parameters_of(const Candidate& candidate) {
  Candidate c = candidate;
  std::vector<NamedValue> result;
  for (const FreeParameter& p : free_parameters())
    if (!p.of_lung || value_of(p, c) > 0.0)
      result.push_back({std::string(p.name), std::string(p.unit), value_of(p, c)});
  return result;
}

void adopt_parameters(const std::vector<NamedValue>& parameters, Scenario& scenario) {
  Candidate c{scenario.parameters, scenario.activation};
  for (const NamedValue& v : parameters) set_value(free_parameter(v.name), v.value, c);
  scenario.parameters = c.parameters;
  scenario.activation = c.activation;
  const auto& a = c.activation;
  if (a.period_s == 0.0 && scenario.time.start == Start::rest)
    scenario.time.duration_s =
        std::max(scenario.time.duration_s, a.onset_s + a.rise_s + a.fast_fall_s + a.slow_fall_s);
}

std::string status_word(Ending::Status status) {
  switch (status) {
    case Ending::Status::completed:
      return "completed";
    case Ending::Status::diverged:
      return "diverged";
    case Ending::Status::volume_lost:
      return "volume_lost";
    case Ending::Status::unset:
      break;
  }
  return "not_run";
}

RunRecord run_record(const ScenarioFile& file, const Trunk& trunk, const BreathRun& run,
                     const MeasuredCurve& measured, const Provenance& provenance) {
  RunRecord r;
  r.title = file.scenario.title;
  r.status = status_word(run.ending.status);
  r.message = run.ending.message;
  r.scenario_toml = scenario_text(file);
  if (file.scenario.mesh) r.trunk_pml = trunk_pml(file.scenario);
  r.parameters = parameters_of({file.scenario.parameters, file.scenario.activation});
  r.measures = measures_of(run);
  const auto recoil_s = run.ending.completed() ? recoil_time_s(trunk, file.scenario) : std::nullopt;
  r.measures.push_back({"recoil_time_s", "s", recoil_s.value_or(std::nan(""))});
  if (!run.frames.empty()) {
    r.trajectory = trajectory_of(trunk, run, file.scenario.time.dt_s);
    r.frame_series = frame_series(trunk, run);
  }
  add_curves(run, curve_steps(run, file.scenario), measured, r);
  r.provenance = provenance;
  return r;
}

}  // namespace trunk
