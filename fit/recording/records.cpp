#include "recording/records.hpp"

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"

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
  for (const auto& [name, particles] : trunk.regions) {
    if (name == "spine") continue;  // overlaps others: a particle has one region in the file
    for (int i : particles)
      t.region[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(t.region_names.size());
    t.region_names.push_back(name);
  }
  t.component_names = {"abdomen_and_diaphragm", "lung"};
  for (const auto& [triangles, component] :
       {std::pair{&trunk.mesh.abdomen, 0}, std::pair{&trunk.mesh.lung, 1}})
    for (const auto& [i, j, k] : *triangles) {
      t.triangles.push_back({i, j, k});
      t.triangle_component.push_back(component);
    }
  for (const Fibre& f : trunk.model.fibres) t.fibres.push_back({f.insertion, f.origin});
  return t;
}

std::vector<double> scaled_by(double factor, std::vector<double> values) {
  for (double& v : values) v *= factor;
  return values;
}

/// The scenario in full, so that it can be run again, with the text the user gave as comments at its end.
std::string scenario_text(const ScenarioFile& file) {
  std::string text = to_toml(file.scenario) + "\n# as given in " + file.path + ":\n# ";
  for (char c : file.text) {
    text += c;
    if (c == '\n') text += "# ";
  }
  return text + "\n";
}

std::vector<NamedValue> statistics_of(const Estimation& e) {
  std::vector<NamedValue> s = {
      {"nrmse_percent", "percent", 100.0 * e.quality.nrmse},
      {"tidal_volume_measured_ml", "ml", e.quality.tidal_volume_m3 / ml},
      {"tidal_volume_error_ml", "ml", e.quality.tidal_volume_error_m3 / ml},
      {"peak_time_error_s", "s", e.quality.peak_time_error_s},
      {"baseline_nrmse_percent", "percent", 100.0 * e.quality.baseline_nrmse},
      {"failed_evaluations", "1", static_cast<double>(e.failures)},
  };
  if (e.uncertainty) {
    s.push_back({"residual_autocorrelation", "1", e.uncertainty->residual_autocorrelation});
    s.push_back({"condition_number", "1", e.uncertainty->condition_number});
    s.push_back({"ratio", "1", e.uncertainty->ratio.value});
    s.push_back({"ratio_lower95", "1", e.uncertainty->ratio.lower95});
    s.push_back({"ratio_upper95", "1", e.uncertainty->ratio.upper95});
  }
  return s;
}

std::vector<FitRecord::Parameter> fitted_parameters(const SearchSpace& space, const Candidate& start,
                                                    const Estimation& e) {
  std::vector<FitRecord::Parameter> result;
  Candidate initial = start, best = e.best;
  for (const FreeParameter& p : free_parameters()) {
    FitRecord::Parameter r;
    r.name = p.name;
    r.unit = p.unit;
    r.initial = p.field(initial);
    r.best = p.field(best);
    r.lower = p.lower;
    r.upper = p.upper;
    r.free = false;
    r.stderr_ = r.lower95 = r.upper95 = std::nan("");
    for (std::size_t i = 0; i < space.size(); ++i)
      if (space.parameter(i).name == p.name) {
        r.free = true;
        if (!e.uncertainty) continue;
        const Estimate& u = e.uncertainty->parameters[i];
        r.stderr_ = u.stderr_;
        r.lower95 = u.lower95;
        r.upper95 = u.upper95;
        r.at_bound = u.at_bound;
      }
    result.push_back(r);
  }
  return result;
}

void add_evaluations(const SearchSpace& space, const Estimation& e, FitRecord& fit) {
  for (std::size_t i = 0; i < space.size(); ++i) fit.evaluation_names.emplace_back(space.parameter(i).name);
  for (const Evaluation& evaluation : e.evaluations) {
    Candidate c = space.decode(evaluation.x);
    for (std::size_t i = 0; i < space.size(); ++i) fit.evaluation_x.push_back(space.parameter(i).field(c));
    const bool done = evaluation.status == Summary::Status::completed;
    fit.evaluation_objective.push_back(done ? evaluation.objective : std::nan(""));
    fit.evaluation_status.push_back(done ? 0 : static_cast<std::int32_t>(evaluation.status));
    fit.evaluation_wall_s.push_back(evaluation.wall_s);
  }
}

}  // namespace

std::vector<NamedValue> measures_of(const BreathRun& run) {
  if (!run.summary.completed()) {  // half a breath has no measures
    BreathRun unknown;
    unknown.summary.status = Summary::Status::completed;
    std::vector<NamedValue> values = measures_of(unknown);
    for (NamedValue& v : values) v.value = std::nan("");
    return values;
  }
  const Measures& m = run.measures;
  const double peak_Pa =
      run.pressure_Pa.empty() ? 0.0 : *std::max_element(run.pressure_Pa.begin(), run.pressure_Pa.end());
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
          {"abdominal_pressure_peak_cmH2O", "cmH2O", peak_Pa / Pa_per_cmH2O}};
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

FitRecord fit_record(const ScenarioFile& file, const Trunk& trunk, const SearchSpace& space,
                     const Target& target, const MeasuredBreath& breath, const Estimation& e,
                     const SearchOptions& options, const std::string& status, const BreathRun& run,
                     const Provenance& provenance) {
  FitRecord fit;
  fit.title = file.scenario.title;
  fit.status = status;
  fit.message = e.search.stop_reason;
  fit.scenario_toml = scenario_text(file);
  fit.verdict = e.uncertainty ? e.uncertainty->verdict : "";
  fit.stop_reason = e.search.stop_reason;
  fit.algorithm = options.algorithm;
  fit.parameters = fitted_parameters(space, {file.scenario.parameters, file.scenario.activation}, e);
  add_evaluations(space, e, fit);
  if (e.uncertainty) {
    fit.covariance_names = fit.evaluation_names;
    const Eigen::MatrixXd& c = e.uncertainty->log_covariance;
    for (Eigen::Index i = 0; i < c.rows(); ++i)
      for (Eigen::Index j = 0; j < c.cols(); ++j) fit.covariance.push_back(c(i, j));
  }
  fit.measured_time_s = target.time_s;
  fit.measured_m3 = target.delta_v;
  fit.sigma_m3 = breath.sigma_m3;
  if (target.is_tidal_volume()) {
    fit.measured_time_s = {run.time_s[static_cast<std::size_t>(
        std::max_element(run.delta_v.begin(), run.delta_v.end()) - run.delta_v.begin())]};
    fit.sigma_m3 = {};
  }
  fit.result_time_s = fit.measured_time_s;
  fit.dV_fit_m3.assign(e.model.data(), e.model.data() + e.model.size());
  for (std::size_t i = 0; i < fit.dV_fit_m3.size(); ++i)
    fit.residual_m3.push_back(fit.dV_fit_m3[i] - target.delta_v[i]);
  fit.statistics = statistics_of(e);
  fit.provenance = provenance;

  ScenarioFile best = file;
  best.scenario.parameters = e.best.parameters;
  best.scenario.activation = e.best.activation;
  fit.best_run = run_record(best, trunk, run, target, provenance);
  return fit;
}

}  // namespace trunk
