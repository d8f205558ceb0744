#include "subject/record.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"
#include "math/units.hpp"
#include "subject/fit_summary.hpp"

namespace trunk {
namespace {

void add(const Predicted& p, bool structural, std::vector<NamedValue>& numbers) {
  numbers.push_back({p.name, p.unit, p.value});
  numbers.push_back({p.name + "_median", p.unit, p.median});
  numbers.push_back({p.name + "_lower95", p.unit, p.lower95});
  numbers.push_back({p.name + "_upper95", p.unit, p.upper95});
  if (!structural) return;
  for (NamedValue& end : structural_intervals_of({p})) numbers.push_back(std::move(end));
}

FitRecord::Result record_of(const FitResult& r) {
  return {r.name,       r.unit,   r.value,   r.lower95, r.upper95,        std::string(name_of(r.grade)),
          r.assumption, r.reason, r.meaning, 0,         text_of(r.shares)};
}

}  // namespace

void add_results(const FitResults& results, FitRecord& record) {
  record.grade = name_of(results.grade);
  record.identifiable = results.grade <= Grade::assumption;
  record.verdict = results.verdict;
  for (const Gate& gate : results.gates) record.gates.push_back({gate.name, gate.sentence});
  for (const FitResult& r : results.results) record.results.push_back(record_of(r));
  for (FitRecord::Result& r : record.results) {
    const auto at = std::find(results.headline.begin(), results.headline.end(), r.name);
    if (at != results.headline.end())
      r.headline = static_cast<std::int32_t>(at - results.headline.begin()) + 1;
  }
  if (!results.straight) return;
  for (const FitResult& r : results.straight->results) record.straight.push_back(record_of(r));
  record.straight_nrmse_percent = 100.0 * results.straight->nrmse;
}

void add_starts(const SubjectFit& fit, FitRecord& record) {
  const auto values = [&](const Candidate& c) {
    std::vector<double> all;
    for (std::size_t i = 0; i < fit.space().size(); ++i) all.push_back(value_of(fit.space().parameter(i), c));
    return all;
  };
  for (const LocalSearch& s : fit.compartment_searches())
    record.starts.push_back({values(s.from), values(s.to), s.objective, s.converged});
}

std::string short_name(const std::string& scenario) {
  return std::filesystem::path(scenario).stem().string();
}

double median_latency_s(const std::vector<BreathRefit>& breaths) {
  std::vector<double> all;
  for (const BreathRefit& b : breaths) all.push_back(b.latency_s);
  return all.empty() ? std::nan("") : median(std::move(all));
}

void add_breaths(const std::vector<BreathRefit>& breaths, FitRecord& record) {
  if (breaths.empty()) return;
  const auto column = [&](const char* name, const char* unit, auto value) {
    NamedColumn c{name, unit, {}};
    for (const BreathRefit& b : breaths) c.values.push_back(value(b));
    record.breaths.push_back(std::move(c));
  };
  using B = BreathRefit;
  column("number", "1", [](const B& b) { return static_cast<double>(b.number); });
  column("onset_s", "s", [](const B& b) { return b.onset_s; });
  column("tidal_volume_ml", "ml", [](const B& b) { return ml_per_m3 * b.tidal_volume_m3; });
  column("k_muscle", "N/m", [](const B& b) { return b.muscle.value; });
  column("k_muscle_stderr", "N/m", [](const B& b) { return b.muscle.stderr_; });
  column("k_muscle_lower95", "N/m", [](const B& b) { return b.muscle.lower95; });
  column("k_muscle_upper95", "N/m", [](const B& b) { return b.muscle.upper95; });
  column("nrmse_percent", "percent", [](const B& b) { return 100.0 * b.nrmse; });
  column("evaluations", "1", [](const B& b) { return static_cast<double>(b.evaluations); });
  column("latency_ms", "ms", [](const B& b) { return 1e3 * b.latency_s; });
  for (const B& b : breaths)
    record.breath_status.push_back(b.error.empty() ? b.status : b.status + ": " + b.error);
}

void add_clinic(const MeasuredBreath& breath, const std::vector<ClinicNumber>& numbers, FitRecord& record) {
  if (numbers.empty()) return;
  if (record.breaths.empty()) {
    record.breaths = {{"number", "1", {}}, {"onset_s", "s", {}}, {"tidal_volume_ml", "ml", {}}};
    for (const Breath& b : breath.used) {
      record.breaths[0].values.push_back(static_cast<double>(b.number));
      record.breaths[1].values.push_back(b.onset_s);
      record.breaths[2].values.push_back(ml_per_m3 * b.tidal_volume_m3);
      record.breath_status.push_back("measured");
    }
  }
  const std::vector<double> rows = record.breaths[0].values;  // their numbers
  for (const ClinicNumber& number : numbers) {
    NamedColumn column{number.name, number.unit, std::vector<double>(rows.size(), std::nan(""))};
    for (std::size_t b = 0; b < breath.used.size(); ++b) {
      const auto row = std::find(rows.begin(), rows.end(), static_cast<double>(breath.used[b].number));
      if (row != rows.end()) column.values[static_cast<std::size_t>(row - rows.begin())] = number.each[b];
    }
    record.breaths.push_back(std::move(column));
  }
}

void add_predictions(const std::vector<Prediction>& predictions, FitRecord& record) {
  for (const Prediction& p : predictions) {
    FitRecord::Prediction r{short_name(p.scenario), p.scenario,     {},
                            p.delta_v_draws_m3,     p.own_draws_m3, p.structure};
    for (const Predicted& number : p.numbers) add(number, !p.structure.empty(), r.numbers);
    r.numbers.push_back({"failed", "1", static_cast<double>(p.failed)});
    record.predictions.push_back(std::move(r));
  }
}

}  // namespace trunk
