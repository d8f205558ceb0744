#pragma once

#include <functional>

#include "dynamics/time_grid.hpp"
#include "validation/table1.hpp"

namespace trunk {

/// The numbers of one simulated breath that validation uses.
struct ValidatedBreath {
  std::string title, status, message;  // status as in `simulate --json`
  Start start = Start::rest;           // of the scenario
  bool lung = false;                   // the scenario has one
  Table1Row row;                       // this and all numbers below are NaN if the breath did not complete
  double right_dome_mm = 0.0;          // descent at end-inspiration; negative if the dome rises
  double left_dome_mm = 0.0;
  double right_most_risen_mm = 0.0;  // the same where it is lowest over the breath
  double left_most_risen_mm = 0.0;
  double volume_error = 0.0;  // largest relative error of the abdominal volume over the breath
  // NaN without a lung; swings are the largest changes from end-expiration, with their signs.
  double gastric_swing_cmH2O = 0.0, pleural_swing_cmH2O = 0.0, transdiaphragmatic_swing_cmH2O = 0.0;
  double recoil_time_s = 0.0;
};

/// The paper's table and all simulated breaths: what the bounds compare.
struct ValidationRun {
  Table1 paper;
  ValidatedBreath published_healthy, healthy;
  ValidatedBreath craighero;                                // the trunk registered to the paper's own subject
  ValidatedBreath hemiparalysis_right, hemiparalysis_left;  // twin: healthy
  ValidatedBreath exercise_healthy, exercise_hemiparalysis_right;
};

/// A scenario that validation runs, and the member that holds its breath.
struct ValidatedScenario {
  std::string_view name;  // scenarios/NAME.toml
  ValidatedBreath ValidationRun::*breath;
};
std::span<const ValidatedScenario> validated_scenarios();

/// A breath with one hemidiaphragm paralysed, and its twin: the same trunk and activation without paralysis.
struct ParalysedPair {
  std::string_view name;
  ValidatedBreath ValidationRun::*breath;
  ValidatedBreath ValidationRun::*twin;
  double ValidatedBreath::*paralysed_dome;
  double ValidatedBreath::*healthy_dome;

  /// Returns dV in percent of the healthy twin's.
  double volume_percent(const ValidationRun& f) const;
};
std::span<const ParalysedPair> paralysed_pairs();

/// Simulates every scenario of validated_scenarios() in `folder`, and calls `note` with each name before it
/// runs. Throws InputError if a file cannot be read. A breath that diverges is no error; its status says so.
ValidationRun run_validation(const std::filesystem::path& table1, const std::filesystem::path& folder,
                             const std::function<void(std::string_view name)>& note);

}  // namespace trunk
