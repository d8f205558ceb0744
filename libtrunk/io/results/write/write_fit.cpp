#include "results/write/write_fit.hpp"

#include <algorithm>

#include "results/hdf5/read.hpp"
#include "results/write/layout.hpp"

namespace trunk {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_array, hdf5::write_axis;
using Parameter = FitRecord::Parameter;

const std::string unit_in_table = "in the unit that `unit` gives for the parameter";

/// Returns one member of all parameters.
template <typename Member>
auto column(const std::vector<Parameter>& parameters, Member member) {
  std::vector<std::remove_cvref_t<decltype(parameters.front().*member)>> values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.*member);
  return values;
}

std::vector<std::int32_t> flags(const std::vector<Parameter>& parameters, bool Parameter::*member) {
  std::vector<std::int32_t> values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.*member ? 1 : 0);
  return values;
}

std::vector<std::string> file_units(const std::vector<Parameter>& parameters) {
  std::vector<std::string> units;
  for (const Parameter& parameter : parameters) units.push_back(layout::file_unit(parameter.unit));
  return units;
}

void write_problem(hid_t root, const FitRecord& fit) {
  const Group problem = create_group(root, "problem");
  if (!fit.input.empty()) hdf5::write_attribute(problem, "input", fit.input);
  write_text(problem, {"scenario_toml", "", "the scenario as it was given"}, fit.scenario_toml);
  const Axis time = write_axis(problem, {"time", "s", "time"}, fit.measured_time_s);
  write_array(problem, {"measured", "ml", "measured volume change"}, layout::to_ml(fit.measured_m3), {time});
  if (!fit.sigma_m3.empty()) {
    write_array(problem, {"sigma", "ml", "standard deviation of measured"}, layout::to_ml(fit.sigma_m3),
                {time});
  }
  const Axis parameter =
      write_axis(problem, {"parameter", "", "parameter"}, column(fit.parameters, &Parameter::name));
  const Axis bound = write_axis(problem, {"bound", "", "bound"}, std::vector<std::string>{"lower", "upper"});
  write_array(problem, {"unit", "", "unit of the parameter"}, file_units(fit.parameters), {parameter});
  std::vector<double> bounds;
  for (const Parameter& one : fit.parameters) bounds.insert(bounds.end(), {one.lower, one.upper});
  write_array(problem, {"bounds", "", "limits of the search, " + unit_in_table}, bounds, {parameter, bound});
}

void write_channels(hid_t root, const FitRecord& fit) {
  if (fit.channels.empty()) return;
  const Group channels = create_group(root, "channels");
  const Axis time = write_axis(channels, {"time", "s", "time"}, fit.measured_time_s);
  for (const FitRecord::Channel& c : fit.channels) {
    const Group one = create_group(channels, c.name);
    hdf5::write_attribute(one, "long_name", c.meaning);
    const std::string unit = layout::file_unit(c.unit);
    write_array(one, {"measured", unit, "measured " + c.meaning}, c.measured, {time});
    write_array(one, {"sigma", unit, "standard deviation of measured over breaths"}, c.sigma, {time});
    if (c.model.empty()) continue;
    std::vector<double> residual;
    for (std::size_t i = 0; i < c.model.size(); ++i) residual.push_back(c.model[i] - c.measured[i]);
    write_array(one, {"model", unit, c.meaning + " of the best simulation"}, c.model, {time});
    write_array(one, {"residual", unit, "model - measured"}, residual, {time});
  }
}

void write_covariance(hid_t parameters, const FitRecord& fit) {
  if (fit.covariance.empty()) return;
  const Axis row = write_axis(parameters, {"covariance_row", "", "parameter"}, fit.covariance_names);
  const Axis across = write_axis(parameters, {"covariance_column", "", "parameter"}, fit.covariance_names);
  write_array(parameters, {"covariance", "1", "covariance of the natural logarithms of the parameters"},
              fit.covariance, {row, across});
}

void write_parameters(hid_t root, const FitRecord& fit) {
  const Group parameters = create_group(root, "parameters");
  const auto& all = fit.parameters;
  const Axis name = write_axis(parameters, {"name", "", "parameter"}, column(all, &Parameter::name));
  write_array(parameters, {"unit", "", "unit of the parameter"}, file_units(all), {name});
  const auto write = [&](const char* what, const std::string& meaning, double Parameter::*member) {
    write_array(parameters, {what, "", meaning + ", " + unit_in_table}, column(all, member), {name});
  };
  write("initial", "start of the search", &Parameter::initial);
  write("lower", "lower limit of the search", &Parameter::lower);
  write("upper", "upper limit of the search", &Parameter::upper);
  write("best", "best value", &Parameter::best);
  write("stderr", "standard error of best", &Parameter::stderr_);
  write("lower95", "lower end of the 95 % interval", &Parameter::lower95);
  write("upper95", "upper end of the 95 % interval", &Parameter::upper95);
  write("naive_lower95", "lower end if all samples are taken as independent", &Parameter::naive_lower95);
  write("naive_upper95", "upper end if all samples are taken as independent", &Parameter::naive_upper95);
  write_flags(
      write_array(parameters, {"at_bound", "1", "best is a limit"}, flags(all, &Parameter::at_bound), {name}),
      {"inside", "at_bound"});
  write_flags(
      write_array(parameters, {"free", "1", "varied by the fit"}, flags(all, &Parameter::free), {name}),
      {"fixed", "free"});
  write_flags(write_array(parameters, {"beside", "1", "estimated along with the free ones"},
                          flags(all, &Parameter::beside), {name}),
              {"no", "beside"});
  if (!fit.bootstrap_lower95.empty()) {
    write_array(parameters, {"bootstrap_lower95", "", "lower end by resampled residuals, " + unit_in_table},
                fit.bootstrap_lower95, {name});
    write_array(parameters, {"bootstrap_upper95", "", "upper end by resampled residuals, " + unit_in_table},
                fit.bootstrap_upper95, {name});
  }
  write_covariance(parameters, fit);
}

std::string unit_of(const std::vector<Parameter>& parameters, const std::string& name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return found == parameters.end() ? "" : layout::file_unit(found->unit);
}

void write_evaluations(hid_t root, const FitRecord& fit) {
  const Group evaluations = create_group(root, "evaluations");
  const Axis one =
      write_count_axis(evaluations, {"evaluation", "1", "evaluation"}, fit.evaluation_objective.size());
  const Axis parameter = write_axis(evaluations, {"parameter", "", "parameter"}, fit.evaluation_names);
  std::vector<std::string> units;
  for (const std::string& name : fit.evaluation_names) units.push_back(unit_of(fit.parameters, name));
  write_array(evaluations, {"unit", "", "unit of the parameter"}, units, {parameter});
  write_array(evaluations, {"x", "", "the tried values, " + unit_in_table}, fit.evaluation_x,
              {one, parameter});
  write_array(evaluations, {"objective", "1", "objective"}, fit.evaluation_objective, {one});
  write_array(evaluations, {"status", "1", "outcome of the simulation, 0 = done"}, fit.evaluation_status,
              {one});
  if (layout::is_reproducible()) return;
  write_array(evaluations, {"wall_s", "s", "time the evaluation took"}, fit.evaluation_wall_s, {one});
}

void write_result(hid_t root, const FitRecord& fit) {
  const Group result = create_group(root, "result");
  hdf5::write_attribute(result, "verdict", fit.verdict);
  hdf5::write_attribute(result, "stop_reason", fit.stop_reason);
  hdf5::write_attribute(result, "algorithm", fit.algorithm);
  hdf5::write_attribute(result, "identifiable", std::int32_t{fit.identifiable});
  if (!fit.cross_check.first.empty()) {
    hdf5::write_attribute(result, "cross_check_first", fit.cross_check.first);
    hdf5::write_attribute(result, "cross_check_second", fit.cross_check.second);
    hdf5::write_attribute(result, "cross_check_agree", std::int32_t{fit.cross_check.agree});
  }
  const Axis time = write_axis(result, {"time", "s", "time"}, fit.result_time_s);
  write_array(result, {"dV_fit", "ml", "volume change of the best simulation"}, layout::to_ml(fit.dV_fit_m3),
              {time});
  write_array(result, {"residual", "ml", "model - measured"}, layout::to_ml(fit.residual_m3), {time});
  if (!fit.dV_baseline_m3.empty())
    write_array(result,
                {"dV_baseline", "ml", "volume change of a one-compartment model, fitted to the same data"},
                layout::to_ml(fit.dV_baseline_m3), {time});
  if (!fit.notes.empty()) {
    const Axis note = write_count_axis(result, {"note", "1", "note"}, fit.notes.size());
    write_array(result, {"notes", "", "on what was read, then on the fit"}, fit.notes, {note});
  }
  layout::write_numbers(create_group(result, "statistics"), fit.statistics);
}

void write_starts(hid_t root, const FitRecord& fit) {
  if (fit.starts.empty()) return;
  const Group starts = create_group(root, "starts");
  const Axis one = write_count_axis(starts, {"start", "1", "local search"}, fit.starts.size());
  const Axis parameter = write_axis(starts, {"parameter", "", "parameter"}, fit.evaluation_names);
  std::vector<double> from, to, objective;
  std::vector<std::int32_t> converged;
  for (const FitRecord::Start& s : fit.starts) {
    from.insert(from.end(), s.from.begin(), s.from.end());
    to.insert(to.end(), s.to.begin(), s.to.end());
    objective.push_back(s.objective);
    converged.push_back(s.converged ? 1 : 0);
  }
  write_array(starts, {"from", "", "where it began, " + unit_in_table}, from, {one, parameter});
  write_array(starts, {"to", "", "where it ended, " + unit_in_table}, to, {one, parameter});
  write_array(starts, {"objective", "1", "objective at its end"}, objective, {one});
  write_flags(write_array(starts, {"converged", "1", "whether it converged"}, converged, {one}),
              {"no", "converged"});
}

void write_profiles(hid_t root, const FitRecord& fit) {
  if (fit.profiles.empty()) return;
  const Group profiles = create_group(root, "profiles");
  for (const FitRecord::Profile& p : fit.profiles) {
    const Group one = create_group(profiles, p.name);
    const Axis value = write_axis(one, {"value", layout::file_unit(p.unit), p.name}, p.value);
    write_array(one, {"deviance", "1", "-2 log likelihood above its best, AR(1)"}, p.deviance, {value});
    write_flags(write_array(one, {"at_bound", "1", "another parameter is at its bound"}, p.at_bound, {value}),
                {"inside", "at_bound"});
    layout::write_numbers(one, {{"lower95", p.unit, p.lower95},
                                {"upper95", p.unit, p.upper95},
                                {"threshold95", "1", p.threshold95}});
  }
}

void write_surface(hid_t root, const FitRecord& fit) {
  const FitRecord::Surface& s = fit.surface;
  if (s.deviance.empty()) return;
  const Group surface = create_group(root, "surface");
  const auto axis = [&](int i, const char* name) {
    return write_axis(surface, {name, layout::file_unit(s.unit[i]), s.name[i]}, s.axis[i]);
  };
  const Axis first = axis(0, "first"), second = axis(1, "second");
  write_array(surface, {"deviance", "1", "-2 log likelihood above its best, AR(1)"}, s.deviance,
              {first, second});
  layout::write_numbers(surface, {{"threshold95", "1", s.threshold95},
                                  {"first_lower95", s.unit[0], s.lower95[0]},
                                  {"first_upper95", s.unit[0], s.upper95[0]},
                                  {"second_lower95", s.unit[1], s.lower95[1]},
                                  {"second_upper95", s.unit[1], s.upper95[1]}});
  hdf5::write_attribute(surface, "closed", std::int32_t{s.closed});
}

void write_breaths(hid_t root, const FitRecord& fit) {
  if (fit.breaths.empty()) return;
  const Group breaths = create_group(root, "breaths");
  const Axis one =
      write_count_axis(breaths, {"fitted_breath", "1", "fitted breath"}, fit.breaths.front().values.size());
  for (const NamedColumn& c : fit.breaths)
    if (!layout::is_reproducible() || !layout::is_clock_time(c.name))
      write_array(breaths, {c.name, layout::file_unit(c.unit), c.name}, c.values, {one});
  write_array(breaths, {"status", "", "outcome of the fit of this breath"}, fit.breath_status, {one});
}

void write_predictions(hid_t root, const FitRecord& fit) {
  if (fit.predictions.empty()) return;
  const Group predictions = create_group(root, "predictions");
  for (const FitRecord::Prediction& p : fit.predictions) {
    const Group one = create_group(predictions, p.name);
    hdf5::write_attribute(one, "scenario", p.scenario);
    layout::write_numbers(one, p.numbers);
    layout::write_structure(one, p.structure);
    if (p.delta_v_m3.empty()) continue;
    const Axis draw = write_count_axis(one, {"draw", "1", "draw of the parameters"}, p.delta_v_m3.size());
    write_array(one, {"delta_v_draws", "ml", "tidal volume"}, layout::to_ml(p.delta_v_m3), {draw});
    write_array(one, {"own_delta_v_draws", "ml", "tidal volume in the scenario of the fit, same draw"},
                layout::to_ml(p.own_delta_v_m3), {draw});
  }
}

void write_draws(hid_t root, const FitRecord& fit) {
  if (fit.draws.values.empty()) return;
  const Group draws = create_group(root, "draws");
  const Axis one =
      write_count_axis(draws, {"draw", "1", "draw"}, fit.draws.values.size() / fit.draws.names.size());
  const Axis parameter = write_axis(draws, {"parameter", "", "parameter"}, fit.draws.names);
  write_array(draws, {"value", "", "parameters as likely as the fit says, " + unit_in_table},
              fit.draws.values, {one, parameter});
}

/// Writes the best run. It has the provenance of the fit, since it is from the same program and the same
/// call.
void write_best_run(hid_t root, const FitRecord& fit) {
  const Group best = create_group(root, "best_run");
  layout::write_schema(best, "run");
  layout::write_run_content(best, fit.best_run);
  hdf5::link_again(root, "provenance", best, "provenance");
  // Readers of trajectories look at the root.
  if (fit.best_run.trajectory.particles > 0)
    for (const char* name : {"h5md", "particles", "connectivity", "observables", "VTKHDF"})
      if (hdf5::has_link(best, name)) hdf5::link_again(best, name, root, name);
}

}  // namespace

void write_fit(const std::filesystem::path& path, const FitRecord& fit) {
  layout::store(path, "fit", [&](hid_t root) {
    hdf5::write_attribute(root, "title", fit.title);
    hdf5::write_attribute(root, "status", fit.status);
    hdf5::write_attribute(root, "message", fit.message);
    write_problem(root, fit);
    write_channels(root, fit);
    write_parameters(root, fit);
    write_evaluations(root, fit);
    write_starts(root, fit);
    write_profiles(root, fit);
    write_surface(root, fit);
    write_breaths(root, fit);
    write_predictions(root, fit);
    write_draws(root, fit);
    write_result(root, fit);
    layout::write_results(root, fit);
    layout::write_provenance(root, fit.provenance);
    write_best_run(root, fit);
  });
}

}  // namespace trunk
