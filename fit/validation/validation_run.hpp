#pragma once

#include <functional>

#include "validation/table1.hpp"

namespace trunk {

/// What validation reads off one simulated breath.
struct ValidatedBreath {
  std::string title, status, message;  // status as in `simulate --json`
  Table1Row row;                       // NaN, like all below, where the breath did not end
  double right_dome_mm = 0.0;          // descent at end-inspiration; below 0 the dome rises
  double left_dome_mm = 0.0;
  double volume_error = 0.0;  // largest of the abdominal volume, relative, over the breath
};

/// Everything the bounds are about.
struct ValidationRun {
  Table1 paper;
  ValidatedBreath published_healthy, healthy;
  ValidatedBreath craighero;                                // the trunk registered to the paper's own subject
  ValidatedBreath hemiparalysis_right, hemiparalysis_left;  // twin: healthy
  ValidatedBreath exercise_healthy, exercise_hemiparalysis_right;
};

/// A scenario that validation runs, and where its breath goes.
struct ValidatedScenario {
  std::string_view name;  // scenarios/NAME.toml
  ValidatedBreath ValidationRun::*breath;
};
std::span<const ValidatedScenario> validated_scenarios();

/// A breath with one hemidiaphragm paralysed, beside the same trunk and activation without.
struct ParalysedPair {
  std::string_view name;
  ValidatedBreath ValidationRun::*breath;
  ValidatedBreath ValidationRun::*twin;
  double ValidatedBreath::*paralysed_dome;
  double ValidatedBreath::*healthy_dome;

  /// dV, percent of the healthy twin's.
  double volume_percent(const ValidationRun& f) const;
};
std::span<const ParalysedPair> paralysed_pairs();

/// Simulates every scenario of validated_scenarios() in `folder`. `note` is called with the name of each
/// before it runs. Throws InputError on files that cannot be read; a breath that diverges is a finding.
ValidationRun run_validation(const std::filesystem::path& table1, const std::filesystem::path& folder,
                             const std::function<void(std::string_view name)>& note);

}  // namespace trunk
