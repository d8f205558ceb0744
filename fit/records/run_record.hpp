#pragma once

#include "estimation/estimate.hpp"
#include "math/units.hpp"
#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// The Table 1 row and what goes with it, in ml, mm and cmH2O, named as in `simulate --json`.
std::vector<NamedValue> measures_of(const BreathSummary& run);

/// Every parameter a fit could vary, natural units.
std::vector<NamedValue> parameters_of(const Candidate& candidate);

/// Takes over parameters by name, as a run or fit file holds them; the simulation is made to last at least as
/// long as the activation. Throws InputError on a name that is unknown.
void adopt_parameters(const std::vector<NamedValue>& parameters, Scenario& scenario);

/// A word for the status of a simulation: "completed", "diverged", "volume_lost".
std::string status_word(Ending::Status status);

/// `measured` is empty or has the curve a fit was held against, sampled at the run's times.
RunRecord run_record(const ScenarioFile& file, const Trunk& trunk, const BreathRun& run,
                     const MeasuredCurve& measured, const Provenance& provenance);

/// The scenario in full, so that it can be run again, with the text the user gave as comments at its end.
std::string scenario_text(const ScenarioFile& file);

}  // namespace trunk
