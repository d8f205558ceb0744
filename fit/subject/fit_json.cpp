#include "subject/fit_json.hpp"

#include <algorithm>

#include "math/units.hpp"
#include "records/fit_record.hpp"
#include "subject/clinic_json.hpp"
#include "subject/fit_summary.hpp"
#include "subject/observable_noise.hpp"
#include "subject/window_json.hpp"

namespace trunk {
namespace {

Json matrix_json(const Eigen::MatrixXd& m) {
  Json matrix = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < m.cols(); ++j) row.push_back(json_number(m(i, j)));
    matrix.push_back(row);
  }
  return matrix;
}

Json activation_json(const SubjectFit& fit, const Estimation& e) {
  const auto& a = e.best.activation;
  const Timing timing = fit.plan().timing;
  Json json{{"onset_s", a.onset_s},
            {"rise_s", a.rise_s},
            {"fast_fall_s", a.fast_fall_s},
            {"slow_fall_s", a.slow_fall_s},
            {"fast_fall_level", a.fast_fall_level},
            {"shape", a.shape},
            {"from_trace", timing != Timing::scenario},
            {"timing", timing == Timing::joint   ? "joint"
                       : timing == Timing::trace ? "trace"
                                                 : "scenario"}};
  Json beside = Json::object();
  if (e.uncertainty)
    for (const Estimate& p : e.uncertainty->beside) beside[p.name] = to_json(p);
  json["estimated_beside"] = beside;
  return json;
}

Json uncertainty_json(const Uncertainty& u) {
  Json json{{"correlation", matrix_json(u.correlation)}};
  json["combinations"] = Json::array();
  for (const Combination& c : u.combinations) {
    Json powers = Json::object();
    for (std::size_t i = 0; i < c.powers.size(); ++i) powers[u.parameters[i].name] = c.powers[i];
    json["combinations"].push_back(
        {{"powers", powers}, {"stderr_percent", json_number(100.0 * c.relative_stderr)}});
  }
  for (const NamedValue& v : noise_numbers(u)) json[v.name] = json_number(v.value);
  return json;
}

Json profiles_json(const Estimation& e) {
  Json json = Json::object();
  for (const Profile& p : e.profiles)
    json[p.name] = {{"lower95", json_number(p.interval95.lower)},
                    {"upper95", json_number(p.interval95.upper)},
                    {"points_with_another_at_bound", std::count(p.at_bound.begin(), p.at_bound.end(), true)}};
  return json;
}

Json surface_json(const LikelihoodSurface& s) {
  Json json{{"points", s.deviance.size()}, {"closed", s.closed}, {"threshold95", s.threshold95}};
  for (int i = 0; i < 2; ++i)
    json["joint95"][s.names[i]] = {{"lower", s.region95[i].lower}, {"upper", s.region95[i].upper}};
  return json;
}

Json bootstrap_json(const Bootstrap& b, const Uncertainty& u) {
  Json json{{"repeats", b.repeats}, {"block_samples", b.block}};
  for (std::size_t i = 0; i < b.interval95.size(); ++i)
    json["parameters"][u.parameters[i].name] = {{"lower95", b.interval95[i].lower},
                                                {"upper95", b.interval95[i].upper}};
  if (!u.ratio.name.empty()) json["ratio"] = {{"lower95", b.ratio95.lower}, {"upper95", b.ratio95.upper}};
  return json;
}

Json breaths_json(const std::vector<BreathRefit>& breaths) {
  Json list = Json::array();
  for (const BreathRefit& b : breaths) {
    Json row{{"number", b.number},
             {"onset_s", b.onset_s},
             {"tidal_volume_ml", ml_per_m3 * b.tidal_volume_m3},
             {"status", b.status},
             {"k_muscle",
              {{"value", json_number(b.muscle.value)},
               {"unit", b.muscle.unit},
               {"stderr", json_number(b.muscle.stderr_)},
               {"lower95", json_number(b.muscle.lower95)},
               {"upper95", json_number(b.muscle.upper95)}}},
             {"nrmse_percent", json_number(100.0 * b.nrmse)},
             {"evaluations", b.evaluations},
             {"latency_ms", 1e3 * b.latency_s}};
    if (!b.error.empty()) row["error"] = b.error;
    list.push_back(std::move(row));
  }
  return list;
}

/// Returns the breaths that were fitted one by one, or else those that were averaged; each with its numbers
/// of a clinic.
Json breaths_json(const SubjectFit& fit, const FitOutcome& outcome) {
  Json list = breaths_json(outcome.breaths);
  const auto& breath = fit.measurement().breath;
  if (!breath || outcome.clinic.empty()) return list;
  const bool refitted = !list.empty();
  for (std::size_t b = 0; b < breath->used.size(); ++b) {
    const Breath& used = breath->used[b];
    if (!refitted)
      list.push_back({{"number", used.number},
                      {"onset_s", used.onset_s},
                      {"tidal_volume_ml", ml_per_m3 * used.tidal_volume_m3}});
    for (Json& row : list)
      if (row["number"] == used.number) row.update(clinic_json_of(outcome.clinic, b));
  }
  return list;
}

/// Returns the noise that each observable has, and how many independent samples it counts for.
Json observables_json(const SubjectFit& fit, const Estimation& e) {
  Json json = Json::object();
  for (const ObservableNoise& o : observable_noises(fit.measured_curve(), e))
    json[o.name] = {{"noise", json_number(o.noise)},
                    {"unit", o.unit},
                    {"autocorrelation", json_number(o.autocorrelation)},
                    {"effective_samples", json_number(o.effective_samples)}};
  return json;
}

Json priors_json(const std::vector<ScalePrior>& scale) {
  Json json = Json::object();
  for (const ScalePrior& p : scale)
    json[p.name] = {{"mean", p.mean}, {"unit", p.unit}, {"factor", p.factor}, {"source", p.source}};
  return json;
}

Json straight_json(const StraightActivation& straight) {
  Json json = Json::object();
  for (const FitResult& r : straight.results) json[r.name] = to_json(r);
  json["nrmse_percent"] = json_number(100.0 * straight.nrmse);
  return json;
}

}  // namespace

Json fit_json(const SubjectFit& fit, const FitOutcome& outcome) {
  const Estimation& e = outcome.estimation;
  Json json{{"schema", "trunk.fit/2"}};
  json["input"] = outcome.input.empty() ? Json(nullptr) : Json(outcome.input);
  json.update(to_json(summary_of(fit, outcome)));
  for (const NamedValue& v : quality_numbers(e)) json[v.name] = json_number(v.value);
  json["tidal_volume_error_percent"] =
      json_number(100.0 * e.quality.tidal_volume_error_m3 / e.quality.tidal_volume_m3);
  if (e.uncertainty)
    json.update(uncertainty_json(*e.uncertainty));
  else
    json["residual_autocorrelation"] = json["condition_number"] = nullptr;
  if (outcome.results.gates.empty()) {  // a gate withholds stiffness, wherever it stands
    if (!e.profiles.empty()) json["profiles"] = profiles_json(e);
    if (e.surface) json["surface"] = surface_json(*e.surface);
    if (e.bootstrap) json["bootstrap"] = bootstrap_json(*e.bootstrap, *e.uncertainty);
  }
  json["activation"] = activation_json(fit, e);
  json["algorithm"] = e.algorithm;
  json["stop_reason"] = e.search.stop_reason;
  json["starts"] = fit.compartment_searches().size();
  json["simulations"] = e.simulations;
  json["notes"] = outcome.notes;
  if (const auto& breath = fit.measurement().breath; breath && breath->window)
    json["window"] = window_json(*breath->window);
  if (!fit.scale().empty()) json["priors"] = priors_json(fit.scale());
  if (e.local && e.local->blocks.size() > 1) json["observables"] = observables_json(fit, e);
  if (outcome.results.straight) json["straight_activation"] = straight_json(*outcome.results.straight);
  if (e.cross_check)
    json["cross_check"] = {{"methods", {e.cross_check->first, e.cross_check->second}},
                           {"largest_difference_percent", 100.0 * e.cross_check->largest_difference()},
                           {"agree", e.cross_check->agree}};
  json["evaluations"] = e.evaluations.size();
  json["replayed"] = outcome.replayed;
  json["failed_evaluations"] = e.failures;
  if (const Json breaths = breaths_json(fit, outcome); !breaths.empty()) json["breaths"] = breaths;
  if (!outcome.clinic.empty()) json["clinic"] = clinic_json(outcome.clinic);
  json["wall_s"] = outcome.wall_s;
  return json;
}

}  // namespace trunk
