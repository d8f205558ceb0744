#include "commands/text/fit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/text/outcome_text.hpp"
#include "subject/record.hpp"

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
    for (const Estimate& p : e.uncertainty->beside) beside[p.name] = interval_json(p);
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
  json["residual_autocorrelation"] = json_number(u.residual_autocorrelation);
  json["noise_autocorrelation"] = json_number(u.noise_autocorrelation);
  json["noise_sigma_ml"] = json_number(1e6 * u.sigma_m3);
  json["degrees_of_freedom"] = json_number(u.freedom);
  json["condition_number"] = json_number(u.condition_number);
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

std::string estimate_line(const Estimate& p, const Profile* profile) {
  const auto range = [](double low, double high) {
    const bool knows_nothing = low > 0.0 && high > 1e4 * low;
    return !knows_nothing && (std::isfinite(low) || std::isfinite(high))
               ? fmt::format("{} to {}", shown(low, "{:.4g}"), shown(high, "{:.4g}"))
               : std::string("not known");
  };
  std::string text =
      fmt::format("  {:<26} {:>10.5g}  {:>10}  {:>20}  {:>20}", p.name, p.value, shown(p.stderr_, "{:.3g}"),
                  range(p.lower95, p.upper95), range(p.naive95.lower, p.naive95.upper));
  if (profile != nullptr)
    text += fmt::format("  {:>20}", range(profile->interval95.lower, profile->interval95.upper));
  return text + " " + (p.unit == "1" ? "" : p.unit) + (p.at_bound ? "  AT BOUND" : "") + "\n";
}

std::string estimates_table(const Estimation& e) {
  if (!e.uncertainty) return "";
  std::string text = fmt::format("  {:<26} {:>10}  {:>10}  {:>20}  {:>20}", "parameter", "estimate",
                                 "std error", "95 % interval", "(if independent)");
  text += e.profiles.empty() ? "\n" : fmt::format("  {:>20}\n", "(by profile)");
  for (std::size_t i = 0; i < e.uncertainty->parameters.size(); ++i)
    text += estimate_line(e.uncertainty->parameters[i], e.profiles.empty() ? nullptr : &e.profiles[i]);
  if (!e.uncertainty->ratio.name.empty()) text += estimate_line(e.uncertainty->ratio, nullptr);
  return text;
}

std::string origin_of(const SubjectFit& fit) {
  switch (fit.plan().timing) {
    case Timing::joint:
      return "estimated along with the parameters";
    case Timing::trace:
      return "from the trace";
    case Timing::scenario:
      break;
  }
  return "of the scenario";
}

}  // namespace

Json interval_json(const Estimate& e) {
  return {{"value", json_number(e.value)},
          {"unit", e.unit},
          {"stderr", json_number(e.stderr_)},
          {"lower95", json_number(e.lower95)},
          {"upper95", json_number(e.upper95)},
          {"naive_lower95", json_number(e.naive95.lower)},
          {"naive_upper95", json_number(e.naive95.upper)},
          {"identifiable", e.identifiable},
          {"at_bound", e.at_bound}};
}

Json fit_json(const SubjectFit& fit, const FitOutcome& outcome) {
  const Estimation& e = outcome.estimation;
  Json json{{"schema", "trunk.fit/1"}, {"status", status_of(e)}};
  json["parameters"] = Json::object();
  if (e.uncertainty) {
    for (const Estimate& p : e.uncertainty->parameters) json["parameters"][p.name] = interval_json(p);
    if (!e.uncertainty->ratio.name.empty()) json["ratio"] = interval_json(e.uncertainty->ratio);
  }
  json["objective"] = json_number(e.search.objective);
  json["nrmse_percent"] = json_number(100.0 * e.quality.nrmse);
  json["tidal_volume_measured_ml"] = json_number(1e6 * e.quality.tidal_volume_m3);
  json["tidal_volume_error_ml"] = json_number(1e6 * e.quality.tidal_volume_error_m3);
  json["tidal_volume_error_percent"] =
      json_number(100.0 * e.quality.tidal_volume_error_m3 / e.quality.tidal_volume_m3);
  json["peak_time_error_s"] = json_number(e.quality.peak_time_error_s);
  json["bic"] = json_number(e.quality.bic);
  json["baseline_nrmse_percent"] = json_number(100.0 * e.quality.baseline_nrmse);
  json["baseline_bic"] = json_number(e.quality.baseline_bic);
  if (e.uncertainty)
    json.update(uncertainty_json(*e.uncertainty));
  else
    json["residual_autocorrelation"] = json["condition_number"] = nullptr;
  json["identifiable"] = e.uncertainty && e.uncertainty->identifiable;
  json["verdict"] =
      e.uncertainty ? e.uncertainty->verdict : "The search did not converge: " + e.search.stop_reason;
  if (!e.profiles.empty()) json["profiles"] = profiles_json(e);
  if (e.surface) json["surface"] = surface_json(*e.surface);
  if (e.bootstrap) json["bootstrap"] = bootstrap_json(*e.bootstrap, *e.uncertainty);
  json["activation"] = activation_json(fit, e);
  json["algorithm"] = e.algorithm;
  json["stop_reason"] = e.search.stop_reason;
  json["starts"] = e.starts.size();
  if (e.cross_check)
    json["cross_check"] = {{"methods", {e.cross_check->first, e.cross_check->second}},
                           {"largest_difference_percent", 100.0 * e.cross_check->largest_difference},
                           {"agree", e.cross_check->agree}};
  json["evaluations"] = e.evaluations.size();
  json["simulated"] = e.simulated;
  json["replayed"] = outcome.replayed;
  json["failed_evaluations"] = e.failures;
  const auto& breath = fit.measurement().breath;
  json["breaths_used"] = breath ? breath->breaths_used : 0;
  json["breaths_rejected"] = breath ? breath->breaths_rejected : 0;
  if (!outcome.breaths.empty()) {
    json["breaths"] = breaths_json(outcome.breaths);
    json["median_latency_ms"] = 1e3 * median_latency_s(outcome.breaths);
  }
  if (!outcome.predictions.empty()) json["predictions"] = predictions_json(outcome.predictions);
  json["wall_s"] = outcome.wall_s;
  return json;
}

std::string fit_table(const SubjectFit& fit, const FitOutcome& outcome) {
  const Estimation& e = outcome.estimation;
  std::string text;
  if (const auto& breath = fit.measurement().breath)
    text += fmt::format("{} breaths used, {} rejected; tidal volume {:.0f} ml, {:.2f} s a breath\n",
                        breath->breaths_used, breath->breaths_rejected, 1e6 * breath->tidal_volume_m3,
                        breath->duration_s);
  text += estimates_table(e);
  text += fmt::format(
      "  residual {:.2f} % of tidal volume (one-compartment model: {:.2f} %), tidal volume {:+.1f} ml, peak "
      "{:+.3f} s\n",
      100.0 * e.quality.nrmse, 100.0 * e.quality.baseline_nrmse, 1e6 * e.quality.tidal_volume_error_m3,
      e.quality.peak_time_error_s);
  const auto& a = e.best.activation;
  text += fmt::format(
      "  activation: onset {:.2f} s, rise {:.2f} s, fast fall {:.2f} s to {:.2g}, slow fall {:.2f} s ({})\n",
      a.onset_s, a.rise_s, a.fast_fall_s, a.fast_fall_level, a.slow_fall_s, origin_of(fit));
  if (e.surface)
    text += fmt::format("  joint 95 % region: {} {:.4g} to {:.4g}, {} {:.4g} to {:.4g}{}\n",
                        e.surface->names[0], e.surface->region95[0].lower, e.surface->region95[0].upper,
                        e.surface->names[1], e.surface->region95[1].lower, e.surface->region95[1].upper,
                        e.surface->closed ? "" : " (reaches the edge of the grid)");
  if (e.bootstrap) {
    text += fmt::format("  95 % by {} bootstrap repeats (blocks of {} samples):", e.bootstrap->repeats,
                        e.bootstrap->block);
    for (std::size_t i = 0; i < e.bootstrap->interval95.size(); ++i)
      text += fmt::format("{} {} {:.4g} to {:.4g}", i > 0 ? "," : "", e.uncertainty->parameters[i].name,
                          e.bootstrap->interval95[i].lower, e.bootstrap->interval95[i].upper);
    text += "\n";
  }
  if (e.cross_check)
    text +=
        fmt::format("  {} and {} {} ({:.2g} % apart)\n", e.cross_check->first, e.cross_check->second,
                    e.cross_check->agree ? "agree" : "DISAGREE", 100.0 * e.cross_check->largest_difference);
  text += fmt::format("  {} evaluations{}, {} failed; {}\n", e.evaluations.size(),
                      outcome.replayed > 0 ? fmt::format(" ({} found from an interrupted run)",
                                                         e.evaluations.size() - e.simulated)
                                           : "",
                      e.failures, e.search.stop_reason);
  text += breaths_table(outcome.breaths) + predictions_table(outcome.predictions);
  return text + (e.uncertainty ? e.uncertainty->verdict : "The search did not converge.");
}

}  // namespace trunk
