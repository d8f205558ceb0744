#include "exports/csv_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace trunk {
namespace {

using Doubles = std::vector<double>;

/// "ml" => "_ml", "N m-1" => "_N_per_m", a pure number nothing.
std::string suffix(const std::string& unit) {
  if (unit.empty() || unit == "1") return "";
  std::string text = "_" + unit;
  for (std::size_t at; (at = text.find("-1")) != std::string::npos;) {
    text.erase(at, 2);
    const std::size_t blank = text.rfind(' ', at);
    if (blank != std::string::npos) text.insert(blank + 1, "per_");
  }
  std::replace(text.begin(), text.end(), ' ', '_');
  return text;
}

std::string cell(double value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// Columns side by side, all as long as the first.
class Table {
 public:
  template <class Value>
  void add(const std::string& name, const std::string& unit, const std::vector<Value>& values) {
    if (values.empty() || (!cells_.empty() && values.size() != cells_.size())) return;
    cells_.resize(values.size());
    const char* comma = header_.empty() ? "" : ",";
    header_ += comma + cell(name + suffix(unit));
    for (std::size_t row = 0; row < values.size(); ++row) {
      if constexpr (std::is_arithmetic_v<Value>)
        cells_[row] += comma + cell(static_cast<double>(values[row]));
      else
        cells_[row] += comma + cell(values[row]);
    }
  }

  std::string csv() const {
    std::string text = header_ + "\n";
    for (const std::string& row : cells_) text += row + "\n";
    return text;
  }

 private:
  std::string header_;
  std::vector<std::string> cells_;
};

/// Of each parameter, each start …: one member.
template <class Record, class Member>
auto each(const std::vector<Record>& records, Member member) {
  std::vector<std::decay_t<std::invoke_result_t<Member, const Record&>>> values;
  for (const Record& record : records) values.push_back(std::invoke(member, record));
  return values;
}

std::string names_and_numbers(const std::vector<NamedValue>& numbers) {
  Table table;
  table.add("name", "", each(numbers, &NamedValue::name));
  table.add("value", "", each(numbers, &NamedValue::value));
  table.add("unit", "", each(numbers, &NamedValue::unit));
  return table.csv();
}

std::string series_over_time(const Doubles& time_s, const std::vector<Series>& series) {
  Table table;
  table.add("time", "s", time_s);
  for (const Series& s : series) table.add(s.name, s.unit, s.values);
  return table.csv();
}

std::vector<std::string> words(const std::vector<std::int32_t>& codes,
                               const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::int32_t code : codes)
    result.push_back(code >= 0 && static_cast<std::size_t>(code) < names.size()
                         ? names[static_cast<std::size_t>(code)]
                         : std::to_string(code));
  return result;
}

/// A row a particle and frame.
std::string positions(const Trajectory& t) {
  std::string text = "time_s,particle,x_m,y_m,z_m";
  if (!t.velocity_m_s.empty()) text += ",vx_m_per_s,vy_m_per_s,vz_m_per_s";
  if (!t.contact.empty()) text += ",contact";
  text += "\n";
  for (std::size_t row = 0; row < t.time_s.size() * t.particles; ++row) {
    const auto three = [&](const Doubles& v) {
      return "," + cell(v[3 * row]) + "," + cell(v[3 * row + 1]) + "," + cell(v[3 * row + 2]);
    };
    text += cell(t.time_s[row / t.particles]) + "," + std::to_string(row % t.particles) + three(t.position_m);
    if (!t.velocity_m_s.empty()) text += three(t.velocity_m_s);
    if (!t.contact.empty()) text += "," + std::to_string(t.contact[row]);
    text += "\n";
  }
  return text;
}

std::string particles(const Trajectory& t) {
  Table table;
  std::vector<int> number(t.particles);
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = static_cast<int>(i);
  table.add("particle", "", number);
  table.add("region", "", words(t.region, t.region_names));
  table.add("rigid", "", words(t.rigid, t.rigid_names));
  table.add("mass", "kg", t.mass_kg);
  return table.csv();
}

template <std::size_t N>
Table corners(const std::vector<std::array<std::int32_t, N>>& cells,
              const std::array<const char*, N>& names) {
  Table table;
  for (std::size_t corner = 0; corner < N; ++corner)
    table.add(names[corner], "", each(cells, [corner](const auto& one) { return one[corner]; }));
  return table;
}

std::vector<NamedText> trajectory_tables(const RunRecord& run) {
  const Trajectory& t = run.trajectory;
  if (t.particles == 0) return {};
  Table triangles = corners<3>(t.triangles, {"a", "b", "c"});
  triangles.add("component", "", words(t.triangle_component, t.component_names));
  Table fibres = corners<2>(t.fibres, {"insertion", "origin"});
  fibres.add("activity", "", t.fibre_activity);
  return {{"frames.csv", series_over_time(t.time_s, run.frame_series)},
          {"positions.csv", positions(t)},
          {"particles.csv", particles(t)},
          {"triangles.csv", triangles.csv()},
          {"fibres.csv", fibres.csv()}};
}

std::string estimates(const FitRecord& fit) {
  using P = FitRecord::Parameter;
  const auto& all = fit.parameters;
  Table table;
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

Doubles in_ml(Doubles volumes_m3) {
  for (double& v : volumes_m3) v *= 1e6;
  return volumes_m3;
}

std::string breath(const FitRecord& fit) {
  Table table;
  table.add("time", "s", fit.result_time_s);
  table.add("measured", "ml", in_ml(fit.measured_m3));
  table.add("sigma", "ml", in_ml(fit.sigma_m3));
  table.add("fit", "ml", in_ml(fit.dV_fit_m3));
  table.add("residual", "ml", in_ml(fit.residual_m3));
  table.add("baseline", "ml", in_ml(fit.dV_baseline_m3));
  return table.csv();
}

/// Every `stride`-th value, from the one at `first`.
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
  Table table;
  const auto& names = fit.evaluation_names;
  for (std::size_t i = 0; i < names.size(); ++i)
    table.add(names[i], unit_of(fit, names[i]), strided(fit.evaluation_x, i, names.size()));
  table.add("objective", "", fit.evaluation_objective);
  table.add("status", "", fit.evaluation_status);
  table.add("wall", "s", fit.evaluation_wall_s);
  return table.csv();
}

std::string starts(const FitRecord& fit) {
  Table table;
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
      text += fmt::format("{},{},{},{},{}\n", cell(p.name), cell(p.value[i]), cell(p.unit),
                          cell(p.deviance[i]), p.at_bound[i]);
  return text;
}

std::string surface(const FitRecord::Surface& s) {
  std::string text = s.name[0] + suffix(s.unit[0]) + "," + s.name[1] + suffix(s.unit[1]) + ",deviance\n";
  for (std::size_t i = 0; i < s.deviance.size(); ++i)
    text += fmt::format("{},{},{}\n", cell(s.axis[0][i / s.axis[1].size()]),
                        cell(s.axis[1][i % s.axis[1].size()]), cell(s.deviance[i]));
  return text;
}

std::string fitted_breaths(const FitRecord& fit) {
  Table table;
  for (const NamedColumn& c : fit.breaths) {
    // Most names end in their unit already.
    const std::string unit = suffix(c.unit);
    table.add(c.name, c.name.ends_with(unit) ? "" : c.unit, c.values);
  }
  table.add("status", "", fit.breath_status);
  return table.csv();
}

std::string predictions(const FitRecord& fit) {
  std::string text = "scenario,name,value,unit\n";
  for (const FitRecord::Prediction& p : fit.predictions)
    for (const NamedValue& n : p.numbers)
      text += fmt::format("{},{},{},{}\n", cell(p.name), cell(n.name), cell(n.value), cell(n.unit));
  return text;
}

}  // namespace

std::vector<NamedText> csv_tables(const RunRecord& run) {
  std::vector<NamedText> files = {{"curves.csv", series_over_time(run.curve_time_s, run.curves)},
                                  {"measures.csv", names_and_numbers(run.measures)},
                                  {"parameters.csv", names_and_numbers(run.parameters)}};
  for (NamedText& file : trajectory_tables(run)) files.push_back(std::move(file));
  return files;
}

std::vector<NamedText> csv_tables(const FitRecord& fit) {
  std::vector<NamedText> files = {
      {"parameters.csv", estimates(fit)},
      {"statistics.csv", names_and_numbers(fit.statistics)},
      {"breath.csv", breath(fit)},
      {"evaluations.csv", evaluations(fit)},
      {"measures.csv", names_and_numbers(fit.best_run.measures)},
      {"curves.csv", series_over_time(fit.best_run.curve_time_s, fit.best_run.curves)}};
  if (!fit.starts.empty()) files.push_back({"starts.csv", starts(fit)});
  if (!fit.profiles.empty()) files.push_back({"profiles.csv", profiles(fit)});
  if (!fit.surface.deviance.empty()) files.push_back({"surface.csv", surface(fit.surface)});
  if (!fit.breaths.empty()) files.push_back({"breaths.csv", fitted_breaths(fit)});
  if (!fit.predictions.empty()) files.push_back({"predictions.csv", predictions(fit)});
  for (NamedText& file : trajectory_tables(fit.best_run)) files.push_back(std::move(file));
  return files;
}

}  // namespace trunk
