#include "exports/csv_table.hpp"
#include "exports/csv_tables.hpp"

namespace trunk {
namespace {

using Doubles = std::vector<double>;

std::vector<std::string> words(const std::vector<std::int32_t>& codes,
                               const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::int32_t code : codes)
    result.push_back(code >= 0 && static_cast<std::size_t>(code) < names.size()
                         ? names[static_cast<std::size_t>(code)]
                         : std::to_string(code));
  return result;
}

/// Returns one row for each particle and frame.
std::string positions(const Trajectory& t) {
  std::string text = "time_s,particle,x_m,y_m,z_m";
  if (!t.velocity_m_s.empty()) text += ",vx_m_per_s,vy_m_per_s,vz_m_per_s";
  if (!t.contact.empty()) text += ",contact";
  text += "\n";
  for (std::size_t row = 0; row < t.time_s.size() * t.particles; ++row) {
    const auto three = [&](const Doubles& v) {
      return "," + csv_cell(v[3 * row]) + "," + csv_cell(v[3 * row + 1]) + "," + csv_cell(v[3 * row + 2]);
    };
    text +=
        csv_cell(t.time_s[row / t.particles]) + "," + std::to_string(row % t.particles) + three(t.position_m);
    if (!t.velocity_m_s.empty()) text += three(t.velocity_m_s);
    if (!t.contact.empty()) text += "," + std::to_string(t.contact[row]);
    text += "\n";
  }
  return text;
}

std::string particles(const Trajectory& t) {
  CsvTable table;
  std::vector<int> number(t.particles);
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = static_cast<int>(i);
  table.add("particle", "", number);
  table.add("region", "", words(t.region, t.region_names));
  table.add("rigid", "", words(t.rigid, t.rigid_names));
  table.add("mass", "kg", t.mass_kg);
  return table.csv();
}

template <std::size_t N>
CsvTable corners(const std::vector<std::array<std::int32_t, N>>& cells,
                 const std::array<const char*, N>& names) {
  CsvTable table;
  for (std::size_t corner = 0; corner < N; ++corner)
    table.add(names[corner], "", each(cells, [corner](const auto& one) { return one[corner]; }));
  return table;
}

}  // namespace

std::vector<NamedText> csv_trajectory_tables(const RunRecord& run) {
  const Trajectory& t = run.trajectory;
  if (t.particles == 0) return {};
  CsvTable triangles = corners<3>(t.triangles, {"a", "b", "c"});
  triangles.add("component", "", words(t.triangle_component, t.component_names));
  CsvTable fibres = corners<2>(t.fibres, {"insertion", "origin"});
  fibres.add("activity", "", t.fibre_activity);
  return {{"frames.csv", series_over_time(t.time_s, run.frame_series)},
          {"positions.csv", positions(t)},
          {"particles.csv", particles(t)},
          {"triangles.csv", triangles.csv()},
          {"fibres.csv", fibres.csv()}};
}

std::vector<NamedText> csv_tables(const RunRecord& run) {
  std::vector<NamedText> files = {{"curves.csv", series_over_time(run.curve_time_s, run.curves)},
                                  {"measures.csv", names_and_numbers(run.measures)},
                                  {"parameters.csv", names_and_numbers(run.parameters)}};
  if (!run.intervals.empty()) files.push_back({"intervals.csv", names_and_numbers(run.intervals)});
  if (!run.structure.choices.empty()) files.push_back({"structure.csv", choices_and_shares(run.structure)});
  for (NamedText& file : csv_trajectory_tables(run)) files.push_back(std::move(file));
  return files;
}

}  // namespace trunk
