#include "sweep/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "prediction/predicted.hpp"
#include "records/provenance.hpp"
#include "records/run_record.hpp"
#include "results/write/write_sweep.hpp"
#include "scenarios/keys.hpp"
#include "sweep/simulator.hpp"

namespace trunk {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Returns the measures that a row may have. Without a lung it has fewer of them, and those come first.
std::vector<NamedValue> most_measures() {
  BreathSummary with_lung;
  with_lung.swings.emplace();
  return measures_of(with_lung);
}

/// Returns empty columns: the parameters, then the measures.
std::vector<NamedColumn> columns_for(const SweepDesign& design) {
  std::vector<NamedColumn> columns;
  for (const SweepDesign::Axis* axis : design.axes())
    columns.push_back({axis->key, unit_of_key(axis->key), {}});
  for (const NamedValue& m : most_measures()) columns.push_back({m.name, m.unit, {}});
  for (NamedColumn& c : columns) c.values.assign(design.runs(), no_number);
  return columns;
}

SweepRecord empty_table(const SweepDesign& design) {
  SweepRecord table;
  table.title = design.title;
  table.sweep_toml = design.text;
  table.columns = columns_for(design);
  for (std::size_t run = 0; run < design.runs(); ++run) {
    const SweepDesign::Run r = design.run(run);
    table.scenario.push_back(design.scenario_name(run));
    if (!design.subjects.empty()) table.subject.push_back(design.subject_name(run));
    for (std::size_t a = 0; a < r.values.size(); ++a) table.columns[a].values[run] = r.values[a];
  }
  table.status.assign(design.runs(), "missing");
  table.error.resize(design.runs());
  table.run_file.resize(design.runs());
  return table;
}

/// Adds the columns of intervals, once a row has some: then a subject is a fit that keeps draws.
void add_interval_columns(const SweepDesign& design, SweepRecord& table) {
  std::vector<Predicted> numbers;
  for (const NamedValue& m : most_measures()) numbers.push_back({m.name, m.unit});
  for (const NamedValue& end : intervals_of(numbers, 0))
    table.columns.push_back({end.name, end.unit, std::vector<double>(design.runs(), no_number)});
}

void enter(const SweepRow& row, std::size_t first_measure, SweepRecord& table) {
  const std::size_t run = row.run;
  table.status[run] = row.status;
  table.error[run] = row.error;
  table.run_file[run] = row.has_file ? SweepFolder::run_file_name(run) : "";
  for (std::size_t c = first_measure; c < table.columns.size(); ++c) table.columns[c].values[run] = no_number;
  if (row.status != "completed") return;
  const auto put = [&](std::size_t column, double value) { table.columns[column].values[run] = value; };
  for (std::size_t m = 0; m < row.measures.size(); ++m) put(first_measure + m, row.measures[m]);
  if (row.intervals.empty()) return;
  const std::size_t ends = first_measure + most_measures().size();
  for (std::size_t k = 0; k + 1 < row.intervals.size(); ++k) put(ends + k, row.intervals[k]);
  put(table.columns.size() - 1, row.intervals.back());  // failed draws
}

/// Removes the columns of what only a lung has if no run has one.
void drop_lung(SweepRecord& table) {
  const auto lungs = [measures = most_measures()](const NamedColumn& c) {
    const auto of_lung = [&](const NamedValue& m) {
      return c.name == m.name || c.name.starts_with(m.name + "_lower95") ||
             c.name.starts_with(m.name + "_upper95");
    };
    return std::any_of(measures.begin() + static_cast<std::ptrdiff_t>(measures_of(BreathSummary()).size()),
                       measures.end(), of_lung);
  };
  const auto known = [](const NamedColumn& c) {
    return std::any_of(c.values.begin(), c.values.end(), [](double v) { return std::isfinite(v); });
  };
  if (std::none_of(table.columns.begin(), table.columns.end(),
                   [&](const NamedColumn& c) { return lungs(c) && known(c); }))
    std::erase_if(table.columns, lungs);
}

/// Fills in the curves. As in the other columns, the last row visited of a run counts. => curves
void fill_curves(const SweepFolder& folder, std::size_t samples, std::size_t first,
                 std::span<double> curves) {
  std::fill(curves.begin(), curves.end(), no_number);
  folder.for_each_row([&](const SweepRow& row) {
    if (row.run < first || (row.run - first) * samples >= curves.size()) return;
    const auto curve = curves.subspan((row.run - first) * samples, samples);
    std::fill(curve.begin(), curve.end(), no_number);
    std::copy_n(row.curve.begin(), std::min(samples, row.curve.size()), curve.begin());
  });
}

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return text.find_first_of(",\n ") == std::string::npos ? text : '"' + text + '"';
}

std::string csv_of(const SweepRecord& table) {
  const bool subjects = !table.subject.empty();
  std::string text = subjects ? "run,scenario,subject,status,error" : "run,scenario,status,error";
  for (const NamedColumn& c : table.columns) text += "," + c.name;
  for (std::size_t run = 0; run < table.status.size(); ++run) {
    text += fmt::format("\n{},{}", run, quoted(table.scenario[run]));
    if (subjects) text += "," + quoted(table.subject[run]);
    text += fmt::format(",{},{}", table.status[run], quoted(table.error[run]));
    for (const NamedColumn& c : table.columns)
      text += std::isfinite(c.values[run]) ? fmt::format(",{}", c.values[run]) : ",";
  }
  return text + "\n";
}

}  // namespace

TableOutcome write_table(const SweepDesign& design, const SweepFolder& folder, const std::string& argv) {
  SweepRecord table = empty_table(design);
  const std::size_t parameters = design.axes().size(), without_intervals = table.columns.size();
  std::vector<std::size_t> samples(design.runs(), 0);
  folder.for_each_row([&](const SweepRow& row) {
    if (!row.intervals.empty() && table.columns.size() == without_intervals)
      add_interval_columns(design, table);
    enter(row, parameters, table);
    samples[row.run] = row.curve.size();
  });
  drop_lung(table);
  const std::size_t longest = *std::max_element(samples.begin(), samples.end());
  for (std::size_t i = 0; i < longest; ++i)
    table.curve_time_s.push_back(static_cast<double>(i) * curve_step_s);
  table.fill_curves_ml = [&](std::size_t first, std::span<double> curves) {
    fill_curves(folder, longest, first, curves);
  };
  table.provenance = provenance_of({}, argv);
  table.provenance.input_sha256 = folder.inputs();

  replace_file(folder.table_file(), csv_of(table));
  write_sweep(folder.sweep_file(), table);

  const auto count = [&](const char* status) {
    return static_cast<std::size_t>(std::count(table.status.begin(), table.status.end(), status));
  };
  TableOutcome outcome{design.runs(), 0, count("missing")};
  outcome.failed = outcome.runs - outcome.missing - count("completed");
  return outcome;
}

}  // namespace trunk
