#include "sweep/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "io/scenario_keys.hpp"
#include "results/sweep_file.hpp"
#include "results/target_file.hpp"

namespace trunk {
namespace {

constexpr double curve_step_s = 0.01;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The curve every curve_step_s: the nearest earlier sample, so that resuming from files loses no bit.
std::vector<double> thinned(const std::vector<double>& time_s, const std::vector<double>& values) {
  std::vector<double> curve;
  for (std::size_t i = 0; i < time_s.size(); ++i)
    if (time_s[i] >= static_cast<double>(curve.size()) * curve_step_s - 1e-9) curve.push_back(values[i]);
  return curve;
}

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return text.find_first_of(",\n ") == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

SweepTable::SweepTable(const SweepDesign& design) : design_(design), rows_(design.runs()) {}

void SweepTable::add(std::size_t run, std::string run_file, const SweepRow& row) {
  rows_[run] = {row.status, row.error, std::move(run_file), row.measures,
                thinned(row.curve_time_s, row.curve_dV_ml)};
}

std::size_t SweepTable::failures() const noexcept {
  return static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(), [](const Kept& k) {
    return k.status != "completed" && k.status != "missing";
  }));
}

std::vector<NamedColumn> SweepTable::columns() const {
  std::vector<NamedColumn> columns;
  for (const auto& axis : design_.axes) columns.push_back({axis.key, unit_of_key(axis.key), {}});
  const auto with_measures =
      std::find_if(rows_.begin(), rows_.end(), [](const Kept& k) { return !k.measures.empty(); });
  const std::size_t measures = with_measures == rows_.end() ? 0 : with_measures->measures.size();
  for (std::size_t m = 0; m < measures; ++m)
    columns.push_back({with_measures->measures[m].name, with_measures->measures[m].unit, {}});
  for (std::size_t run = 0; run < rows_.size(); ++run) {
    const std::vector<double> values = design_.values_of(run);
    for (std::size_t a = 0; a < values.size(); ++a) columns[a].values.push_back(values[a]);
    const bool completed = rows_[run].status == "completed";
    for (std::size_t m = 0; m < measures; ++m)
      columns[values.size() + m].values.push_back(completed ? rows_[run].measures[m].value : missing);
  }
  return columns;
}

std::string SweepTable::csv() const {
  const std::vector<NamedColumn> all = columns();
  std::string text = "run,scenario,status,error";
  for (const NamedColumn& c : all) text += "," + c.name;
  for (std::size_t run = 0; run < rows_.size(); ++run) {
    text += fmt::format("\n{},{},{},{}", run, quoted(design_.scenario_of(run).stem().string()),
                        rows_[run].status, quoted(rows_[run].error));
    for (const NamedColumn& c : all)
      text += std::isfinite(c.values[run]) ? fmt::format(",{}", c.values[run]) : ",";
  }
  return text + "\n";
}

void SweepTable::write(const SweepFolder& folder, const Provenance& provenance) const {
  SweepRecord record;
  record.title = design_.title;
  record.sweep_toml = design_.text;
  record.columns = columns();
  std::size_t longest = 0;
  for (const Kept& k : rows_) longest = std::max(longest, k.curve.size());
  for (std::size_t i = 0; i < longest; ++i)
    record.curve_time_s.push_back(static_cast<double>(i) * curve_step_s);
  for (std::size_t run = 0; run < rows_.size(); ++run) {
    const Kept& k = rows_[run];
    record.scenario.push_back(design_.scenario_of(run).stem().string());
    record.status.push_back(k.status);
    record.error.push_back(k.error);
    record.run_file.push_back(k.run_file);
    record.curve_dV_ml.insert(record.curve_dV_ml.end(), k.curve.begin(), k.curve.end());
    record.curve_dV_ml.insert(record.curve_dV_ml.end(), longest - k.curve.size(), missing);
  }
  record.provenance = provenance;
  const std::string text = csv();
  replace_file(folder.table_file(), std::as_bytes(std::span(text)));
  write_sweep(folder.sweep_file(), record);
}

}  // namespace trunk
