#include <fmt/format.h>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "results/hdf5/read.hpp"
#include "results/read/open_results.hpp"
#include "results/read/read_numbers.hpp"
#include "results/read/read_parts.hpp"
#include "results/read/read_records.hpp"

namespace trunk {
namespace {

using hdf5::has_link, hdf5::read_doubles, hdf5::read_texts;
using Doubles = std::vector<double>;

double number_of(const std::vector<NamedValue>& numbers, const std::string& name) {
  for (const NamedValue& n : numbers)
    if (n.name == name) return n.value;
  throw hdf5::Error(name + " is missing");
}

Doubles to_m3(Doubles volumes_ml) {
  for (double& v : volumes_ml) v /= ml_per_m3;
  return volumes_ml;
}

/// Reads a column of the table of parameters, and assigns its values to the parameters.
template <typename Assign>
void fill(hid_t root, const std::string& column, FitRecord& fit, Assign assign) {
  const Doubles values = read_doubles(root, "parameters/" + column);
  if (values.size() != fit.parameters.size())
    throw hdf5::Error("parameters/" + column + " has the wrong length");
  for (std::size_t i = 0; i < values.size(); ++i) assign(fit.parameters[i], values[i]);
}

void read_evaluations(hid_t root, FitRecord& fit) {
  fit.evaluation_names = read_texts(root, "evaluations/parameter");
  fit.evaluation_x = read_doubles(root, "evaluations/x");
  fit.evaluation_objective = read_doubles(root, "evaluations/objective");
  for (const double status : read_doubles(root, "evaluations/status"))
    fit.evaluation_status.push_back(static_cast<std::int32_t>(status));
  const std::size_t size = fit.evaluation_objective.size();
  if (has_link(root, "evaluations/wall_s")) fit.evaluation_wall_s = read_doubles(root, "evaluations/wall_s");
  if (fit.evaluation_x.size() != size * fit.evaluation_names.size() || fit.evaluation_status.size() != size)
    throw hdf5::Error("the columns of its evaluations differ in length");
}

void read_starts(hid_t root, FitRecord& fit) {
  if (!has_link(root, "starts")) return;
  const Doubles from = read_doubles(root, "starts/from"), to = read_doubles(root, "starts/to"),
                objective = read_doubles(root, "starts/objective"),
                converged = read_doubles(root, "starts/converged");
  const auto width = static_cast<std::ptrdiff_t>(fit.evaluation_names.size());
  const std::size_t values = objective.size() * fit.evaluation_names.size();
  if (from.size() != values || to.size() != values || converged.size() != objective.size())
    throw hdf5::Error("the columns of its starts differ in length");
  for (std::size_t i = 0; i < objective.size(); ++i) {
    const auto row = [&](const Doubles& all) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(i) * width;
      return Doubles(first, first + width);
    };
    fit.starts.push_back({row(from), row(to), objective[i], converged[i] != 0.0});
  }
}

void read_profiles(hid_t root, FitRecord& fit) {
  if (!has_link(root, "profiles")) return;
  const hdf5::Group profiles = hdf5::open_group(root, "profiles");
  for (const std::string& name : hdf5::link_names(profiles)) {
    const auto limits = layout::read_numbers(profiles, name);
    FitRecord::Profile p;
    p.name = name;
    p.value = read_doubles(profiles, name + "/value");
    p.unit = hdf5::read_attribute_if_any(hdf5::open_dataset(profiles, name + "/value"), "units");
    p.deviance = read_doubles(profiles, name + "/deviance");
    for (const double flag : read_doubles(profiles, name + "/at_bound"))
      p.at_bound.push_back(static_cast<std::int32_t>(flag));
    if (p.deviance.size() != p.value.size() || p.at_bound.size() != p.value.size())
      throw hdf5::Error("the columns of profiles/" + name + " differ in length");
    p.lower95 = number_of(limits, "lower95");
    p.upper95 = number_of(limits, "upper95");
    if (has_link(profiles, name + "/threshold95")) p.threshold95 = number_of(limits, "threshold95");
    fit.profiles.push_back(std::move(p));
  }
}

void read_surface(hid_t root, FitRecord& fit) {
  if (!has_link(root, "surface")) return;
  const hdf5::Group surface = hdf5::open_group(root, "surface");
  const auto limits = layout::read_numbers(root, "surface");
  const char* axes[] = {"first", "second"};
  FitRecord::Surface& s = fit.surface;
  for (int i = 0; i < 2; ++i) {
    const hdf5::Dataset axis = hdf5::open_dataset(surface, axes[i]);
    s.name[i] = hdf5::read_attribute(axis, "long_name");
    s.unit[i] = hdf5::read_attribute(axis, "units");
    s.axis[i] = read_doubles(surface, axes[i]);
    s.lower95[i] = number_of(limits, std::string(axes[i]) + "_lower95");
    s.upper95[i] = number_of(limits, std::string(axes[i]) + "_upper95");
  }
  s.deviance = read_doubles(surface, "deviance");
  s.threshold95 = number_of(limits, "threshold95");
  s.closed = hdf5::read_attribute(surface, "closed") == "1";
  if (s.deviance.size() != s.axis[0].size() * s.axis[1].size())
    throw hdf5::Error("surface/deviance has the wrong shape");
}

void read_breaths(hid_t root, FitRecord& fit) {
  if (!has_link(root, "breaths")) return;
  const hdf5::Group breaths = hdf5::open_group(root, "breaths");
  for (const std::string& name : hdf5::link_names(breaths)) {
    if (name == "fitted_breath") continue;
    if (name == "status") {
      fit.breath_status = read_texts(breaths, name);
      continue;
    }
    fit.breaths.push_back({name, hdf5::read_attribute_if_any(hdf5::open_dataset(breaths, name), "units"),
                           read_doubles(breaths, name)});
  }
}

void read_predictions(hid_t root, FitRecord& fit) {
  if (!has_link(root, "predictions")) return;
  const hdf5::Group predictions = hdf5::open_group(root, "predictions");
  for (const std::string& name : hdf5::link_names(predictions)) {
    const hdf5::Group one = hdf5::open_group(predictions, name);
    FitRecord::Prediction p{name,
                            hdf5::read_attribute(one, "scenario"),
                            layout::read_numbers(predictions, name),
                            {},
                            {},
                            layout::read_structure(one)};
    if (has_link(one, "delta_v_draws")) {
      p.delta_v_m3 = to_m3(read_doubles(one, "delta_v_draws"));
      p.own_delta_v_m3 = to_m3(read_doubles(one, "own_delta_v_draws"));
    }
    fit.predictions.push_back(std::move(p));
  }
}

FitRecord::Draws draws_in(hid_t root) {
  FitRecord::Draws draws;
  if (!has_link(root, "draws")) return draws;
  draws.names = read_texts(root, "draws/parameter");
  draws.values = read_doubles(root, "draws/value");
  if (draws.names.empty() || draws.values.size() % draws.names.size() != 0)
    throw hdf5::Error("draws/value has the wrong shape");
  return draws;
}

void require_fit(const std::filesystem::path& path, const std::string& kind) {
  if (kind != "fit") throw InputError({path.string()}, fmt::format("is a {}", kind), "a fit");
}

void read_result(hid_t root, FitRecord& fit) {
  const hdf5::Group result = hdf5::open_group(root, "result");
  fit.verdict = hdf5::read_attribute(result, "verdict");
  fit.stop_reason = hdf5::read_attribute(result, "stop_reason");
  fit.algorithm = hdf5::read_attribute(result, "algorithm");
  fit.identifiable = hdf5::read_attribute_if_any(result, "identifiable") == "1";
  fit.cross_check = {hdf5::read_attribute_if_any(result, "cross_check_first"),
                     hdf5::read_attribute_if_any(result, "cross_check_second"),
                     hdf5::read_attribute_if_any(result, "cross_check_agree") == "1"};
  fit.result_time_s = read_doubles(result, "time");
  fit.dV_fit_m3 = to_m3(read_doubles(result, "dV_fit"));
  fit.residual_m3 = to_m3(read_doubles(result, "residual"));
  if (has_link(result, "dV_baseline")) fit.dV_baseline_m3 = to_m3(read_doubles(result, "dV_baseline"));
  if (has_link(result, "notes")) fit.notes = read_texts(result, "notes");
  fit.statistics = layout::read_numbers(root, "result/statistics");
  if (fit.dV_fit_m3.size() != fit.result_time_s.size() || fit.residual_m3.size() != fit.result_time_s.size())
    throw hdf5::Error("the curves of its result differ in length");
}

void read_problem(hid_t root, FitRecord& fit) {
  fit.scenario_toml = hdf5::read_text(root, "problem/scenario_toml");
  fit.measured_time_s = read_doubles(root, "problem/time");
  fit.measured_m3 = to_m3(read_doubles(root, "problem/measured"));
  if (has_link(root, "problem/sigma")) fit.sigma_m3 = to_m3(read_doubles(root, "problem/sigma"));
  if (fit.measured_m3.size() != fit.measured_time_s.size())
    throw hdf5::Error("problem/measured has the wrong length");
}

void read_channels(hid_t root, FitRecord& fit) {
  if (!has_link(root, "channels")) return;
  const hdf5::Group channels = hdf5::open_group(root, "channels");
  for (const std::string& name : hdf5::link_names(channels)) {
    if (name == "time") continue;
    const hdf5::Group one = hdf5::open_group(channels, name);
    FitRecord::Channel c{name,
                         hdf5::read_attribute(hdf5::open_dataset(one, "measured"), "units"),
                         hdf5::read_attribute(one, "long_name"),
                         read_doubles(one, "measured"),
                         read_doubles(one, "sigma"),
                         {}};
    if (has_link(one, "model")) c.model = read_doubles(one, "model");
    const std::size_t size = fit.measured_time_s.size();
    if (c.measured.size() != size || c.sigma.size() != size || (!c.model.empty() && c.model.size() != size))
      throw hdf5::Error("the curves of channels/" + name + " have the wrong length");
    fit.channels.push_back(std::move(c));
  }
}

}  // namespace

void layout::read_estimates(hid_t root, FitRecord& fit) {
  using P = FitRecord::Parameter;
  for (const NamedValue& best : layout::read_best_parameters(root)) {
    P p;
    p.name = best.name;
    p.unit = best.unit;
    p.best = best.value;
    fit.parameters.push_back(std::move(p));
  }
  for (const auto& [column, member] : {std::pair{"initial", &P::initial},
                                       {"lower", &P::lower},
                                       {"upper", &P::upper},
                                       {"stderr", &P::stderr_},
                                       {"lower95", &P::lower95},
                                       {"upper95", &P::upper95},
                                       {"naive_lower95", &P::naive_lower95},
                                       {"naive_upper95", &P::naive_upper95}})
    fill(root, column, fit, [member = member](P& p, double value) { p.*member = value; });
  for (const auto& [column, member] :
       {std::pair{"at_bound", &P::at_bound}, {"free", &P::free}, {"beside", &P::beside}})
    fill(root, column, fit, [member = member](P& p, double value) { p.*member = value != 0.0; });
  if (has_link(root, "parameters/covariance")) {
    fit.covariance_names = read_texts(root, "parameters/covariance_row");
    fit.covariance = read_doubles(root, "parameters/covariance");
  }
  if (has_link(root, "parameters/bootstrap_lower95")) {
    fit.bootstrap_lower95 = read_doubles(root, "parameters/bootstrap_lower95");
    fit.bootstrap_upper95 = read_doubles(root, "parameters/bootstrap_upper95");
  }
}

FitRecord read_fit(const std::filesystem::path& path) {
  FitRecord fit;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    require_fit(path, kind);
    fit.title = hdf5::read_attribute(root, "title");
    fit.status = hdf5::read_attribute(root, "status");
    fit.message = hdf5::read_attribute(root, "message");
    read_problem(root, fit);
    read_channels(root, fit);
    layout::read_estimates(root, fit);
    read_evaluations(root, fit);
    read_starts(root, fit);
    read_profiles(root, fit);
    read_surface(root, fit);
    read_breaths(root, fit);
    read_predictions(root, fit);
    fit.draws = draws_in(root);
    read_result(root, fit);
    layout::read_results_of_fit(root, fit);
    fit.provenance = layout::read_provenance(root);
    fit.best_run = layout::read_run_content(hdf5::open_group(root, "best_run"));
  });
  return fit;
}

std::vector<FitRecord::Gate> read_gates(const std::filesystem::path& path) {
  std::vector<FitRecord::Gate> gates;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind == "fit") gates = layout::read_gates_of_fit(root);
  });
  return gates;
}

FitRecord::Draws read_draws(const std::filesystem::path& path) {
  FitRecord::Draws draws;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    require_fit(path, kind);
    draws = draws_in(root);
  });
  return draws;
}

}  // namespace trunk
