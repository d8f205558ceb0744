#include "validation/validation_run.hpp"

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"
#include "records/run_record.hpp"
#include "scenarios/build_trunk.hpp"
#include "validation/usual_ranges.hpp"

namespace trunk {
namespace {

constexpr ValidatedScenario scenarios[] = {
    {"published_healthy", &ValidationRun::published_healthy},
    {"healthy", &ValidationRun::healthy},
    {"craighero", &ValidationRun::craighero},
    {"hemiparalysis_right", &ValidationRun::hemiparalysis_right},
    {"hemiparalysis_left", &ValidationRun::hemiparalysis_left},
    {"exercise_healthy", &ValidationRun::exercise_healthy},
    {"exercise_hemiparalysis_right", &ValidationRun::exercise_hemiparalysis_right}};

constexpr ParalysedPair pairs[] = {
    {"hemiparalysis_right", &ValidationRun::hemiparalysis_right, &ValidationRun::healthy,
     &ValidatedBreath::right_dome_mm, &ValidatedBreath::left_dome_mm},
    {"hemiparalysis_left", &ValidationRun::hemiparalysis_left, &ValidationRun::healthy,
     &ValidatedBreath::left_dome_mm, &ValidatedBreath::right_dome_mm},
    {"exercise_hemiparalysis_right", &ValidationRun::exercise_hemiparalysis_right,
     &ValidationRun::exercise_healthy, &ValidatedBreath::right_dome_mm, &ValidatedBreath::left_dome_mm}};

double value_of(std::span<const NamedValue> measures, std::string_view name) {
  const auto found =
      std::find_if(measures.begin(), measures.end(), [&](const NamedValue& v) { return v.name == name; });
  return found == measures.end() ? std::nan("") : found->value;
}

ValidatedBreath simulated(const std::filesystem::path& scenario) {
  const ScenarioFile file = read_scenario(scenario);
  const Trunk trunk = build_trunk(file);
  const BreathRun run = run_breath(trunk, file.scenario, 0);
  const std::vector<NamedValue> measures = run_record(file, trunk, run, {}, {}).measures;
  ValidatedBreath breath;
  breath.title = file.scenario.title;
  breath.start = file.scenario.time.start;
  breath.lung = file.scenario.lung_acts;
  breath.status = status_word(run.ending.status);
  breath.message = run.ending.message;
  breath.row = row_of(measures);
  breath.right_dome_mm = value_of(measures, "excursion_right_mm");
  breath.left_dome_mm = value_of(measures, "excursion_left_mm");
  breath.right_most_risen_mm = value_of(measures, "excursion_right_most_risen_mm");
  breath.left_most_risen_mm = value_of(measures, "excursion_left_most_risen_mm");
  breath.volume_error = value_of(measures, "max_relative_volume_error");
  for (const UsualRange& range : usual_ranges())
    breath.*range.value = breath.lung ? value_of(measures, range.measure) : std::nan("");
  return breath;
}

}  // namespace

std::span<const ValidatedScenario> validated_scenarios() {
  return scenarios;
}

std::span<const ParalysedPair> paralysed_pairs() {
  return pairs;
}

double ParalysedPair::volume_percent(const ValidationRun& f) const {
  return 100.0 * (f.*breath).row.dv_ml / (f.*twin).row.dv_ml;
}

ValidationRun run_validation(const std::filesystem::path& table1, const std::filesystem::path& folder,
                             const std::function<void(std::string_view name)>& note) {
  ValidationRun findings;
  findings.paper = read_table1(table1);
  for (const ValidatedScenario& scenario : scenarios) {
    note(scenario.name);
    findings.*scenario.breath = simulated(folder / (std::string(scenario.name) + ".toml"));
  }
  return findings;
}

}  // namespace trunk
