#pragma once

#include "estimation/estimate.hpp"
#include "math/units.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Returns the row of Table 1 and further measures, in ml, mm and cmH2O, named as in `simulate --json`. All
/// are NaN if the breath did not complete.
/// Pressures of a lung come last, and only if there is a lung. Excursions are positive where a dome descends,
/// so that of the most risen moment is 0 or negative.
std::vector<NamedValue> measures_of(const BreathSummary& run);

/// Returns every parameter that a fit can vary, in natural units.
std::vector<NamedValue> parameters_of(const Candidate& candidate);

/// Sets parameters by the names that run and fit files use. From rest, it also makes the simulation last at
/// least as long as the activation. Throws InputError if a name is unknown. => scenario
void adopt_parameters(const std::vector<NamedValue>& parameters, Scenario& scenario);

/// Returns the word for a status: "completed", "diverged", "volume_lost", or "not_run".
std::string status_word(Ending::Status status);

/// Returns the record of a run. Its measures are those of measures_of and the recoil time, which is NaN if
/// the trunk does not come to rest. `measured` is the curve that was fitted, on an even grid of times, or
/// empty.
RunRecord run_record(const ScenarioFile& file, const Trunk& trunk, const BreathRun& run,
                     const MeasuredCurve& measured, const Provenance& provenance);

/// Returns the whole scenario as TOML, so that it can be run again. Comments at its end hold the user's own
/// text.
std::string scenario_text(const ScenarioFile& file);

}  // namespace trunk
