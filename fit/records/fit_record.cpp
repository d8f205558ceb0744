#include "records/fit_record.hpp"

#include <algorithm>
#include <cmath>

#include "math/units.hpp"
#include "records/run_record.hpp"

namespace trunk {
namespace {

std::vector<NamedValue> statistics_of(const Estimation& e) {
  std::vector<NamedValue> s = quality_numbers(e);
  s.push_back({"evaluations", "1", static_cast<double>(e.evaluations.size())});
  s.push_back({"failed_evaluations", "1", static_cast<double>(e.failures)});
  if (e.cross_check)
    s.push_back({"methods_differ_percent", "percent", 100.0 * e.cross_check->largest_difference()});
  if (e.uncertainty) {
    const auto noise = noise_numbers(*e.uncertainty);
    s.insert(s.end(), noise.begin(), noise.end());
    s.push_back({"ratio", "1", e.uncertainty->ratio.value});
    s.push_back({"ratio_lower95", "1", e.uncertainty->ratio.lower95});
    s.push_back({"ratio_upper95", "1", e.uncertainty->ratio.upper95});
  }
  return s;
}

void add_interval(const Estimate& u, FitRecord::Parameter& r) {
  r.stderr_ = u.stderr_;
  r.lower95 = u.lower95;
  r.upper95 = u.upper95;
  r.naive_lower95 = u.naive95.lower;
  r.naive_upper95 = u.naive95.upper;
  r.at_bound = u.at_bound;
}

std::vector<double> natural_values(const SearchSpace& space, const Candidate& c) {
  std::vector<double> values;
  for (std::size_t i = 0; i < space.size(); ++i) values.push_back(value_of(space.parameter(i), c));
  return values;
}

std::vector<FitRecord::Parameter> fitted_parameters(const SearchSpace& space, const Candidate& start,
                                                    const Estimation& e) {
  std::vector<FitRecord::Parameter> result;
  const Candidate &initial = start, &best = e.best;
  for (const FreeParameter& p : free_parameters()) {
    if (p.of_lung && value_of(p, best) == 0.0) continue;
    FitRecord::Parameter r;
    r.name = p.name;
    r.unit = p.unit;
    r.initial = value_of(p, initial);
    r.best = value_of(p, best);
    r.lower = p.lower;
    r.upper = p.upper;
    r.free = false;
    r.stderr_ = r.lower95 = r.upper95 = r.naive_lower95 = r.naive_upper95 = std::nan("");
    if (const auto i = space.find(p.name)) {
      r.free = *i < space.asked_for();
      r.beside = !r.free;
      if (e.uncertainty && (r.free || !e.uncertainty->beside.empty()))
        add_interval(r.free ? e.uncertainty->parameters[*i] : e.uncertainty->beside[*i - space.asked_for()],
                     r);
    }
    result.push_back(r);
  }
  return result;
}

void add_evaluations(const SearchSpace& space, const Estimation& e, FitRecord& fit) {
  for (std::size_t i = 0; i < space.size(); ++i) fit.evaluation_names.emplace_back(space.parameter(i).name);
  for (const Evaluation& evaluation : e.evaluations) {
    for (const double v : natural_values(space, evaluation.candidate)) fit.evaluation_x.push_back(v);
    const bool done = evaluation.status == Ending::Status::completed;
    fit.evaluation_objective.push_back(done ? evaluation.objective : std::nan(""));
    fit.evaluation_status.push_back(done ? 0 : static_cast<std::int32_t>(evaluation.status));
    fit.evaluation_wall_s.push_back(evaluation.wall_s);
  }
}

void add_likelihood(const Estimation& e, FitRecord& fit) {
  const double quantile = e.local ? t_quantile(e.local->freedom) : 0.0;
  for (const Profile& p : e.profiles)
    fit.profiles.push_back({p.name,
                            p.unit,
                            p.value,
                            p.deviance,
                            {p.at_bound.begin(), p.at_bound.end()},
                            p.interval95.lower,
                            p.interval95.upper,
                            quantile * quantile});
  if (!e.surface) return;
  for (int i = 0; i < 2; ++i) {
    fit.surface.name[i] = e.surface->names[i];
    fit.surface.unit[i] = e.surface->units[i];
    fit.surface.axis[i] = e.surface->axis[i];
  }
  fit.surface.deviance = e.surface->deviance;
  fit.surface.threshold95 = e.surface->threshold95;
  for (int i = 0; i < 2; ++i) {
    fit.surface.lower95[i] = e.surface->region95[i].lower;
    fit.surface.upper95[i] = e.surface->region95[i].upper;
  }
  fit.surface.closed = e.surface->closed;
}

void add_bootstrap(const SearchSpace& space, const Bootstrap& b, FitRecord& fit) {
  for (const FitRecord::Parameter& p : fit.parameters) {
    const auto i = space.find(p.name);
    const bool resampled = i && *i < b.interval95.size();
    fit.bootstrap_lower95.push_back(resampled ? b.interval95[*i].lower : std::nan(""));
    fit.bootstrap_upper95.push_back(resampled ? b.interval95[*i].upper : std::nan(""));
  }
  fit.statistics.push_back({"bootstrap_repeats", "1", static_cast<double>(b.repeats)});
  fit.statistics.push_back({"bootstrap_ratio_lower95", "1", b.ratio95.lower});
  fit.statistics.push_back({"bootstrap_ratio_upper95", "1", b.ratio95.upper});
}

}  // namespace

std::vector<NamedValue> quality_numbers(const Estimation& e) {
  return {{"nrmse_percent", "percent", 100.0 * e.quality.nrmse},
          {"tidal_volume_measured_ml", "ml", ml_per_m3 * e.quality.tidal_volume_m3},
          {"tidal_volume_error_ml", "ml", ml_per_m3 * e.quality.tidal_volume_error_m3},
          {"peak_time_error_s", "s", e.quality.peak_time_error_s},
          {"baseline_nrmse_percent", "percent", 100.0 * e.quality.baseline_nrmse},
          {"bic", "1", e.quality.bic},
          {"baseline_bic", "1", e.quality.baseline_bic},
          {"objective", "1", e.search.objective}};
}

std::vector<NamedValue> noise_numbers(const Uncertainty& u) {
  return {{"noise_autocorrelation", "1", u.noise_autocorrelation},
          {"noise_sigma_ml", "ml", ml_per_m3 * u.sigma_m3},
          {"degrees_of_freedom", "1", u.freedom},
          {"residual_autocorrelation", "1", u.residual_autocorrelation},
          {"condition_number", "1", u.condition_number}};
}

FitRecord fit_record(const ScenarioFile& file, const Trunk& trunk, const SearchSpace& space,
                     const MeasuredCurve& measured, const std::vector<double>& sigma_m3, const Estimation& e,
                     const std::string& status, const BreathRun& run, const Provenance& provenance) {
  FitRecord fit;
  fit.title = file.scenario.title;
  fit.status = status;
  fit.message = e.search.stop_reason;
  fit.scenario_toml = scenario_text(file);
  fit.stop_reason = e.search.stop_reason;
  fit.algorithm = e.algorithm;
  fit.parameters = fitted_parameters(space, {file.scenario.parameters, file.scenario.activation}, e);
  add_evaluations(space, e, fit);
  add_likelihood(e, fit);
  if (e.uncertainty) {
    for (const Estimate& p : e.uncertainty->parameters) fit.covariance_names.push_back(p.name);
    const Eigen::MatrixXd& c = e.uncertainty->log_covariance;
    for (Eigen::Index i = 0; i < c.rows(); ++i)
      for (Eigen::Index j = 0; j < c.cols(); ++j) fit.covariance.push_back(c(i, j));
  }
  fit.measured_time_s = measured.time_s;
  fit.measured_m3 = measured.delta_v;
  fit.sigma_m3 = sigma_m3;
  if (measured.is_tidal_volume()) {
    fit.measured_time_s = {run.time_s[static_cast<std::size_t>(
        std::max_element(run.delta_v.begin(), run.delta_v.end()) - run.delta_v.begin())]};
    fit.sigma_m3 = {};
  }
  fit.result_time_s = fit.measured_time_s;
  const auto samples = static_cast<Eigen::Index>(measured.delta_v.size());  // the volume comes first
  if (e.model.size() > 0) fit.dV_fit_m3.assign(e.model.data(), e.model.data() + samples);
  for (std::size_t i = 0; i < fit.dV_fit_m3.size(); ++i)
    fit.residual_m3.push_back(fit.dV_fit_m3[i] - measured.delta_v[i]);
  fit.dV_baseline_m3.assign(e.quality.baseline.data(), e.quality.baseline.data() + e.quality.baseline.size());
  fit.statistics = statistics_of(e);
  if (e.bootstrap) add_bootstrap(space, *e.bootstrap, fit);
  if (e.cross_check) fit.cross_check = {e.cross_check->first, e.cross_check->second, e.cross_check->agree};
  fit.provenance = provenance;

  ScenarioFile best = file;
  best.scenario.parameters = e.best.parameters;
  best.scenario.activation = e.best.activation;
  fit.best_run = run_record(best, trunk, run, measured, provenance);
  return fit;
}

}  // namespace trunk
