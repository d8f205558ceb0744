#include "records/stored_subject.hpp"

#include "records/run_record.hpp"
#include "results/read/read_records.hpp"
#include "results/read/results_kind.hpp"
#include "results/read/stored_run.hpp"

namespace trunk {
namespace {

/// Returns each row of the draws, put over the fitted candidate.
std::vector<Candidate> candidates_of(const FitRecord::Draws& draws, const Candidate& fitted) {
  std::vector<Candidate> all;
  const std::size_t width = draws.names.size();
  for (std::size_t first = 0; first < draws.values.size(); first += width) {
    all.push_back(fitted);
    for (std::size_t k = 0; k < width; ++k)
      set_value(free_parameter(draws.names[k]), draws.values[first + k], all.back());
  }
  return all;
}

}  // namespace

StoredSubject read_stored_subject(const std::filesystem::path& path) {
  StoredSubject subject{read_parameters(path), std::nullopt, {}, {}};
  if (kind_of(path) != "fit") return subject;
  const RunInputs inputs = read_run_inputs(path);
  subject.own = scenario_of_text(inputs.scenario_toml, path.string(), inputs.trunk_pml);
  const Scenario& own = subject.own->scenario;
  subject.gates = read_gates(path);
  subject.draws = candidates_of(read_draws(path), {own.parameters, own.activation});
  return subject;
}

void breathe_as(const StoredSubject& subject, Scenario& scenario) {
  if (subject.own) breathe_as(subject.own->scenario, scenario);
  adopt_parameters(subject.parameters, scenario);
}

void breathe_as(const Scenario& subject, Scenario& scenario) {
  scenario.parameters = subject.parameters;
  scenario.activation = subject.activation;
  scenario.time.duration_s = subject.time.duration_s;
  scenario.time.start = subject.time.start;
  // Tissue that was fitted without a lung already has the lung's elastance.
  scenario.lung_acts = subject.lung_acts || !scenario.pleura.airway_pressure.empty();
}

FitRecord::Draws draws_record(const std::vector<Candidate>& draws) {
  FitRecord::Draws record;
  if (draws.empty()) return record;
  for (const NamedValue& v : parameters_of(draws.front())) record.names.push_back(v.name);
  for (const Candidate& c : draws)
    for (const NamedValue& v : parameters_of(c)) record.values.push_back(v.value);
  return record;
}

}  // namespace trunk
