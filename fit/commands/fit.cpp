#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <span>

#include "commands/commands.hpp"
#include "commands/trace_options.hpp"
#include "errors/input_error.hpp"
#include "recording/fit_record.hpp"
#include "recording/provenance.hpp"
#include "recording/run_record.hpp"
#include "results/fit_file.hpp"
#include "results/summary.hpp"
#include "results/target_file.hpp"

namespace trunk {
namespace {

struct FitRequest {
  std::string scenario, trace, output, breath = "mean", save_scenario;
  double tidal_volume_ml = 0.0;
  SignalOptions signal;
  std::vector<std::string> free, fixed, settings;
  SearchOptions search;
  bool keep_timing = false;
};

/// --fix name=value or name=@file.h5. Returns the name.
std::string apply_fixed(const std::string& text, ScenarioFile& file) {
  const std::string expected = "expected name=value or name=@file.h5, as in --fix k_elasticity=4000";
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw InputError("--fix " + text + ": " + expected);
  const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
  const FreeParameter& p = free_parameter(name);
  Candidate c{file.scenario.parameters, file.scenario.activation};
  if (value.starts_with('@')) {
    const std::filesystem::path source = value.substr(1);
    for (const NamedValue& v : read_parameters(source))
      if (v.name == name) p.field(c) = v.value;
    file.inputs.push_back(source);
  } else {
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), p.field(c));
    if (error != std::errc() || end != value.data() + value.size())
      throw InputError("--fix " + text + ": " + expected);
  }
  if (!(p.field(c) >= p.lower && p.field(c) <= p.upper))
    throw InputError(fmt::format("--fix {}: expected {:g} to {:g} {}", text, p.lower, p.upper, p.unit));
  file.scenario.parameters = c.parameters;
  file.scenario.activation = c.activation;
  return name;
}

/// A setting that the trace would overwrite is a contradiction, not a wish.
void require_no_timing(const FitRequest& request) {
  static constexpr std::string_view timed[] = {"activation.onset_s",     "activation.rise_s",
                                               "activation.fast_fall_s", "activation.slow_fall_s",
                                               "activation.period_s",    "time.duration_s"};
  for (const std::string& text : request.settings)
    for (std::string_view key : timed)
      if (setting_of(text).key == key)
        throw InputError(fmt::format(
            "--set {}: the timing is taken from the trace, expected --keep-timing beside it", text));
}

/// The names to fit: what --free says, or the two of the paper (one where there is but one number), less the
/// fixed ones.
std::vector<std::string> names_to_fit(const FitRequest& request, const std::vector<std::string>& fixed) {
  std::vector<std::string> names = request.free;
  if (names.empty())
    names = request.trace.empty() ? std::vector<std::string>{"k_muscle"}
                                  : std::vector<std::string>{"k_elasticity", "k_muscle"};
  for (const std::string& name : fixed) {
    if (!request.free.empty() && std::count(names.begin(), names.end(), name) > 0)
      throw InputError("parameter '" + name + "' is both free and fixed, expected one of the two");
    std::erase(names, name);
  }
  return names;
}

/// The breath to fit. `notes` are for the user, once all input is known to be good.
MeasuredBreath measured_breath(const FitRequest& request, std::vector<std::string>& notes) {
  const Segmentation s = segment_breaths(read_signal(request.trace, request.signal));
  notes = s.notes;
  if (request.breath == "mean") return mean_breath(s);
  std::size_t number = 0;
  const char* end = request.breath.data() + request.breath.size();
  if (std::from_chars(request.breath.data(), end, number).ptr != end || number == 0)
    throw InputError("--breath " + request.breath + ": expected mean or the number of a breath, from 1");
  const MeasuredBreath breath = single_breath(s, number);
  if (!s.breaths[number - 1].kept)
    notes.push_back(
        fmt::format("breath {} would be left out of the mean: {}", number, s.breaths[number - 1].reason));
  return breath;
}

Json interval_json(const Estimate& e) {
  return {{"value", json_number(e.value)},     {"unit", e.unit},
          {"stderr", json_number(e.stderr_)},  {"lower95", json_number(e.lower95)},
          {"upper95", json_number(e.upper95)}, {"at_bound", e.at_bound}};
}

Json correlation_json(const Uncertainty& u) {
  Json matrix = Json::array();
  for (Eigen::Index i = 0; i < u.correlation.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < u.correlation.cols(); ++j) row.push_back(json_number(u.correlation(i, j)));
    matrix.push_back(row);
  }
  return matrix;
}

Json fit_summary(const std::string& status, const FitRequest& request, const Estimation& e,
                 const MeasuredBreath& breath, double wall_s) {
  Json json{{"schema", "trunk.fit/1"}, {"status", status}};
  json["parameters"] = Json::object();
  if (e.uncertainty) {
    for (const Estimate& p : e.uncertainty->parameters) json["parameters"][p.name] = interval_json(p);
    if (!e.uncertainty->ratio.name.empty()) json["ratio"] = interval_json(e.uncertainty->ratio);
    json["correlation"] = correlation_json(*e.uncertainty);
  }
  json["nrmse_percent"] = json_number(100.0 * e.quality.nrmse);
  json["tidal_volume_measured_ml"] = json_number(1e6 * e.quality.tidal_volume_m3);
  json["tidal_volume_error_ml"] = json_number(1e6 * e.quality.tidal_volume_error_m3);
  json["peak_time_error_s"] = json_number(e.quality.peak_time_error_s);
  json["residual_autocorrelation"] =
      e.uncertainty ? json_number(e.uncertainty->residual_autocorrelation) : nullptr;
  json["condition_number"] = e.uncertainty ? json_number(e.uncertainty->condition_number) : nullptr;
  json["identifiable"] = e.uncertainty && e.uncertainty->identifiable;
  json["verdict"] =
      e.uncertainty ? e.uncertainty->verdict : "The search did not converge: " + e.search.stop_reason;
  json["baseline_nrmse_percent"] = json_number(100.0 * e.quality.baseline_nrmse);
  const auto& a = e.best.activation;
  json["activation"] = {{"onset_s", a.onset_s},
                        {"rise_s", a.rise_s},
                        {"fast_fall_s", a.fast_fall_s},
                        {"slow_fall_s", a.slow_fall_s},
                        {"fast_fall_level", a.fast_fall_level},
                        {"from_trace", !request.trace.empty() && !request.keep_timing}};
  json["algorithm"] = request.search.algorithm;
  json["stop_reason"] = e.search.stop_reason;
  json["evaluations"] = e.evaluations.size();
  json["failed_evaluations"] = e.failures;
  json["breaths_used"] = breath.breaths_used;
  json["breaths_rejected"] = breath.breaths_rejected;
  json["wall_s"] = wall_s;
  return json;
}

std::string table(const Estimation& e, const MeasuredBreath& breath, const FitRequest& request) {
  std::string text;
  if (breath.breaths_used > 0)
    text += fmt::format("{} breaths used, {} rejected; tidal volume {:.0f} ml, {:.2f} s a breath\n",
                        breath.breaths_used, breath.breaths_rejected, 1e6 * breath.tidal_volume_m3,
                        breath.duration_s);
  text +=
      fmt::format("  {:<26} {:>10}  {:>10}  {:>22}\n", "parameter", "estimate", "std error", "95 % interval");
  const auto line = [&](const Estimate& p) {
    const std::string interval =
        std::isfinite(p.stderr_) ? fmt::format("{:.4g} to {:.4g}", p.lower95, p.upper95) : "not known";
    text +=
        fmt::format("  {:<26} {:>10.5g}  {:>10}  {:>22} {}{}\n", p.name, p.value, shown(p.stderr_, "{:.3g}"),
                    interval, p.unit == "1" ? "" : p.unit, p.at_bound ? "  AT BOUND" : "");
  };
  if (e.uncertainty) {
    for (const Estimate& p : e.uncertainty->parameters) line(p);
    if (!e.uncertainty->ratio.name.empty()) line(e.uncertainty->ratio);
  }
  text += fmt::format(
      "  residual {:.2f} % of tidal volume (one-compartment model: {:.2f} %), tidal volume {:+.1f} ml, peak "
      "{:+.3f} s\n",
      100.0 * e.quality.nrmse, 100.0 * e.quality.baseline_nrmse, 1e6 * e.quality.tidal_volume_error_m3,
      e.quality.peak_time_error_s);
  const auto& a = e.best.activation;
  text += fmt::format("  activation: rise {:.2f} s, fast fall {:.2f} s to {:.2g}, slow fall {:.2f} s ({})\n",
                      a.rise_s, a.fast_fall_s, a.fast_fall_level, a.slow_fall_s,
                      request.trace.empty() || request.keep_timing ? "of the scenario" : "from the trace");
  text += fmt::format("  {} evaluations, {} failed; {}\n", e.evaluations.size(), e.failures,
                      e.search.stop_reason);
  text += e.uncertainty ? e.uncertainty->verdict : "The search did not converge.";
  return text + "\nWritten to " + request.output;
}

/// Six digits are more than any trace determines, and stay readable in a scenario file.
Scenario with_rounded(Scenario scenario, const SearchSpace& space, const Candidate& best) {
  Candidate c = best;
  for (std::size_t i = 0; i < space.size(); ++i) {
    double& value = space.parameter(i).field(c);
    value = std::stod(fmt::format("{:.6g}", value));
  }
  scenario.parameters = c.parameters;
  scenario.activation = c.activation;
  return scenario;
}

/// The fitted scenario in full: it needs no other file.
void save_scenario(const FitRequest& request, const Scenario& scenario) {
  const std::string text = fmt::format("# {} with the parameters of {}, written by trunk fit\n{}",
                                       request.scenario, request.output, to_toml(scenario));
  replace_file(request.save_scenario, std::as_bytes(std::span(text)));
}

void require_one_source(const FitRequest& request) {
  if (request.trace.empty() == (request.tidal_volume_ml == 0.0))
    throw InputError("expected a measurement: --trace FILE or --tidal-volume-ml ML, one of the two");
  if (request.trace.empty() && !(request.tidal_volume_ml >= 10.0 && request.tidal_volume_ml <= 10000.0))
    throw InputError(fmt::format("--tidal-volume-ml {:g}: expected 10 to 10000 ml", request.tidal_volume_ml));
}

Exit fit_command(const Common& common, const FitRequest& request) {
  require_one_source(request);
  ScenarioFile file = read_scenario(request.scenario, request.settings);
  MeasuredBreath breath;
  std::vector<std::string> notes;
  Target target{{}, {1e-6 * request.tidal_volume_ml}};
  const bool timing_from_trace = !request.trace.empty() && !request.keep_timing;
  if (timing_from_trace) require_no_timing(request);
  if (!request.trace.empty()) {
    breath = measured_breath(request, notes);
    target = target_of(breath);
    file.inputs.push_back(request.trace);
    file.scenario.time.duration_s = breath.duration_s;
    if (timing_from_trace) adopt_timing(breath, file.scenario);
  }
  std::vector<std::string> fixed;
  for (const std::string& text : request.fixed) fixed.push_back(apply_fixed(text, file));
  const SearchSpace space(names_to_fit(request, fixed), {file.scenario.parameters, file.scenario.activation});
  const Trunk trunk = build_trunk(file);
  std::vector<std::filesystem::path> outputs = {request.output};
  if (!request.save_scenario.empty()) outputs.emplace_back(request.save_scenario);
  require_apart(file.inputs, outputs);
  for (const auto& output : outputs) require_writable_target(output, common.force);
  for (const std::string& note : notes) print_note("note: " + note);

  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  int asked = 0;
  const Estimation e =
      estimate(trunk, file.scenario, space, target, {request.search, timing_from_trace}, [&] {
        print_progress(fmt::format("fitting: {} evaluations", ++asked));
        return interrupted();
      });
  if (interrupted()) {
    print_note("interrupted: nothing written");
    return Exit::interrupted;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (!e.search.best.size() || e.model.size() == 0)
    throw std::runtime_error("no simulation completed (" + e.search.stop_reason + "): nothing written");

  const bool identifiable = e.uncertainty && e.uncertainty->identifiable;
  const std::string status = !e.search.converged ? "not_converged"
                             : identifiable      ? "converged"
                                                 : "not_identifiable";
  ScenarioFile best = file;
  best.scenario.parameters = e.best.parameters;
  best.scenario.activation = e.best.activation;
  const int stride =
      std::max(1, static_cast<int>(std::lround(best.scenario.frame_every_s / best.scenario.time.dt_s)));
  const BreathRun run = run_breath(trunk, best.scenario, stride);
  write_fit(request.output, fit_record(file, trunk, space, target, breath, e, request.search, status, run,
                                       provenance_of(file.inputs, common.argv)));
  if (!request.save_scenario.empty()) save_scenario(request, with_rounded(best.scenario, space, e.best));
  print_result(common, fit_summary(status, request, e, breath, wall.count()), table(e, breath, request));
  if (!e.search.converged) return Exit::not_converged;
  return identifiable ? Exit::done : Exit::not_identifiable;
}

}  // namespace

void add_fit(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand("fit", "Fit k_elasticity and k_muscle to a lung volume trace");
  const auto r = std::make_shared<FitRequest>();
  command->add_option("SCENARIO", r->scenario, "scenario file (TOML)")->required();
  command->add_option("--trace", r->trace, "lung volume or flow trace (CSV)");
  command->add_option("--tidal-volume-ml", r->tidal_volume_ml,
                      "fit k_muscle to this one number instead of a trace");
  command->add_option("-o,--output", r->output, "result file (HDF5)")->required();
  command->add_option("--free", r->free, "parameters to fit, comma separated [k_elasticity,k_muscle]")
      ->delimiter(',');
  command->add_option("--fix", r->fixed, "name=value or name=@fit.h5; may be repeated")->take_all();
  command->add_option("--set", r->settings, "key=value, over the scenario; may be repeated")->take_all();
  command->add_option("--algorithm", r->search.algorithm, "bobyqa, sbplx, cobyla or neldermead [bobyqa]");
  command
      ->add_option("--max-evaluations", r->search.max_evaluations, "simulations at most in each search [600]")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--breath", r->breath, "mean, or the number of one breath [mean]");
  command->add_flag("--keep-timing", r->keep_timing, "activation as timed by the scenario, not by the trace");
  command->add_option("--save-scenario", r->save_scenario,
                      "write the scenario with the fitted values to this file");
  add_signal_options(*command, r->signal);
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace result files that exist");
  command->callback([&common, &run, r] { run = [&common, r] { return fit_command(common, *r); }; });
}

}  // namespace trunk
