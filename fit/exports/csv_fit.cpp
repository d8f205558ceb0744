#include <fmt/format.h>

#include "exports/csv_table.hpp"
#include "exports/csv_tables.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

using Doubles = std::vector<double>;

std::string estimates(const FitRecord& fit) {
  using P = FitRecord::Parameter;
  const auto& all = fit.parameters;
  CsvTable table;
  table.add("parameter", "", each(all, &P::name));
  table.add("best", "", each(all, &P::best));
  table.add("unit", "", each(all, &P::unit));
  table.add("stderr", "", each(all, &P::stderr_));
  table.add("lower95", "", each(all, &P::lower95));
  table.add("upper95", "", each(all, &P::upper95));
  table.add("naive_lower95", "", each(all, &P::naive_lower95));
  table.add("naive_upper95", "", each(all, &P::naive_upper95));
  table.add("bootstrap_lower95", "", fit.bootstrap_lower95);
  table.add("bootstrap_upper95", "", fit.bootstrap_upper95);
  table.add("initial", "", each(all, &P::initial));
  table.add("lower", "", each(all, &P::lower));
  table.add("upper", "", each(all, &P::upper));
  table.add("how", "", each(all, [](const P& p) {
              return std::string(p.free ? "free" : p.beside ? "beside" : "fixed");
            }));
  table.add("at_bound", "", each(all, [](const P& p) { return p.at_bound ? 1 : 0; }));
  return table.csv();
}

std::string results(const std::vector<FitRecord::Result>& all) {
  using R = FitRecord::Result;
  CsvTable table;
  table.add("result", "", each(all, &R::name));
  table.add("value", "", each(all, &R::value));
  table.add("unit", "", each(all, &R::unit));
  table.add("lower95", "", each(all, &R::lower95));
  table.add("upper95", "", each(all, &R::upper95));
  table.add("grade", "", each(all, &R::grade));
  table.add("assumption", "", each(all, &R::assumption));
  table.add("reason", "", each(all, &R::reason));
  table.add("meaning", "", each(all, &R::meaning));
  table.add("headline", "", each(all, &R::headline));
  return table.csv();
}

/// Returns the sentences of a fit: verdict, gates and notes, and what they are about.
std::string verdict(const FitRecord& fit) {
  std::vector<std::pair<std::string, std::string>> lines = {
      {"status", fit.status}, {"grade", fit.grade}, {"verdict", fit.verdict}, {"input", fit.input}};
  for (const FitRecord::Gate& gate : fit.gates) lines.emplace_back("gate " + gate.name, gate.sentence);
  for (const std::string& note : fit.notes) lines.emplace_back("note", note);
  std::string text = "what,text\n";
  for (const auto& [what, sentence] : lines)
    if (!sentence.empty()) text += csv_cell(what) + "," + csv_cell(sentence) + "\n";
  return text;
}

Doubles in_ml(Doubles volumes_m3) {
  for (double& v : volumes_m3) v *= ml_per_m3;
  return volumes_m3;
}

std::string breath(const FitRecord& fit) {
  CsvTable table;
  table.add("time", "s", fit.result_time_s);
  table.add("measured", "ml", in_ml(fit.measured_m3));
  table.add("sigma", "ml", in_ml(fit.sigma_m3));
  table.add("fit", "ml", in_ml(fit.dV_fit_m3));
  table.add("residual", "ml", in_ml(fit.residual_m3));
  table.add("baseline", "ml", in_ml(fit.dV_baseline_m3));
  for (const FitRecord::Channel& c : fit.channels) {
    table.add(c.name + "_measured", c.unit, c.measured);
    table.add(c.name + "_sigma", c.unit, c.sigma);
    table.add(c.name + "_fit", c.unit, c.model);
  }
  return table.csv();
}

/// Returns every `stride`-th value from index `first` on.
Doubles strided(const Doubles& all, std::size_t first, std::size_t stride) {
  Doubles some;
  for (std::size_t i = first; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

std::string unit_of(const FitRecord& fit, const std::string& name) {
  for (const FitRecord::Parameter& p : fit.parameters)
    if (p.name == name) return p.unit;
  return "";
}

std::string evaluations(const FitRecord& fit) {
  CsvTable table;
  const auto& names = fit.evaluation_names;
  for (std::size_t i = 0; i < names.size(); ++i)
    table.add(names[i], unit_of(fit, names[i]), strided(fit.evaluation_x, i, names.size()));
  table.add("objective", "", fit.evaluation_objective);
  table.add("status", "", fit.evaluation_status);
  table.add("wall", "s", fit.evaluation_wall_s);
  return table.csv();
}

std::string starts(const FitRecord& fit) {
  CsvTable table;
  using S = FitRecord::Start;
  for (std::size_t i = 0; i < fit.evaluation_names.size(); ++i) {
    const std::string& name = fit.evaluation_names[i];
    table.add("from_" + name, unit_of(fit, name), each(fit.starts, [i](const S& s) { return s.from[i]; }));
    table.add("to_" + name, unit_of(fit, name), each(fit.starts, [i](const S& s) { return s.to[i]; }));
  }
  table.add("objective", "", each(fit.starts, &S::objective));
  table.add("converged", "", each(fit.starts, [](const S& s) { return s.converged ? 1 : 0; }));
  return table.csv();
}

std::string profiles(const FitRecord& fit) {
  std::string text = "parameter,value,unit,deviance,at_bound\n";
  for (const FitRecord::Profile& p : fit.profiles)
    for (std::size_t i = 0; i < p.value.size(); ++i)
      text += fmt::format("{},{},{},{},{}\n", csv_cell(p.name), csv_cell(p.value[i]), csv_cell(p.unit),
                          csv_cell(p.deviance[i]), p.at_bound[i]);
  return text;
}

std::string surface(const FitRecord::Surface& s) {
  std::string text =
      s.name[0] + unit_suffix(s.unit[0]) + "," + s.name[1] + unit_suffix(s.unit[1]) + ",deviance\n";
  for (std::size_t i = 0; i < s.deviance.size(); ++i)
    text += fmt::format("{},{},{}\n", csv_cell(s.axis[0][i / s.axis[1].size()]),
                        csv_cell(s.axis[1][i % s.axis[1].size()]), csv_cell(s.deviance[i]));
  return text;
}

std::string fitted_breaths(const FitRecord& fit) {
  CsvTable table;
  for (const NamedColumn& c : fit.breaths) {
    // Most names already end in their unit.
    const std::string unit = unit_suffix(c.unit);
    table.add(c.name, c.name.ends_with(unit) ? "" : c.unit, c.values);
  }
  table.add("status", "", fit.breath_status);
  return table.csv();
}

std::string predictions(const FitRecord& fit) {
  std::string text = "scenario,name,value,unit\n";
  for (const FitRecord::Prediction& p : fit.predictions)
    for (const NamedValue& n : p.numbers)
      text += fmt::format("{},{},{},{}\n", csv_cell(p.name), csv_cell(n.name), csv_cell(n.value),
                          csv_cell(n.unit));
  return text;
}

}  // namespace

std::vector<NamedText> csv_tables(const FitRecord& fit) {
  std::vector<NamedText> files = {
      {"verdict.csv", verdict(fit)},
      {"parameters.csv", estimates(fit)},
      {"statistics.csv", names_and_numbers(fit.statistics)},
      {"breath.csv", breath(fit)},
      {"evaluations.csv", evaluations(fit)},
      {"measures.csv", names_and_numbers(fit.best_run.measures)},
      {"curves.csv", series_over_time(fit.best_run.curve_time_s, fit.best_run.curves)}};
  if (!fit.results.empty()) files.push_back({"results.csv", results(fit.results)});
  if (!fit.straight.empty()) files.push_back({"straight_activation.csv", results(fit.straight)});
  if (!fit.starts.empty()) files.push_back({"starts.csv", starts(fit)});
  if (!fit.profiles.empty()) files.push_back({"profiles.csv", profiles(fit)});
  if (!fit.surface.deviance.empty()) files.push_back({"surface.csv", surface(fit.surface)});
  if (!fit.breaths.empty()) files.push_back({"breaths.csv", fitted_breaths(fit)});
  if (!fit.predictions.empty()) files.push_back({"predictions.csv", predictions(fit)});
  for (const FitRecord::Prediction& p : fit.predictions)
    if (!p.structure.choices.empty())
      files.push_back({"structure_" + p.name + ".csv", choices_and_shares(p.structure)});
  for (NamedText& file : csv_trajectory_tables(fit.best_run)) files.push_back(std::move(file));
  return files;
}

}  // namespace trunk
