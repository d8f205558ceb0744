#pragma once

#include <algorithm>

#include "problem/search_space.hpp"
#include "scenarios/read_scenario.hpp"
#include "subject/fixed_parameters.hpp"

namespace trunk {

/// Returns the names of the parameters that make up the timing of an activation of straight lines.
std::vector<std::string> timing_names();

/// What is fitted and what is held.
struct FitDraft {
  std::vector<std::string> names, beside;  // asked for; estimated along with these
  std::vector<FixedParameter> fixed;

  /// Reads what --free and --fix say. Throws InputErrors if they contradict each other.
  FitDraft(const std::vector<std::string>& free, const std::vector<std::string>& held, bool one_number);

  bool has(std::string_view name) const { return std::count(names.begin(), names.end(), name) > 0; }
  /// Returns the times and the level that are estimated beside what is asked for.
  std::vector<std::string> timing() const;
  /// Lets the course of the activation be estimated, but what is held of it. => beside
  void estimate_beside(bool straight);
  /// Gives the scenario what is held. => file
  void hold(ScenarioFile& file) const;
};

/// Returns the error about an option that names a parameter of a lung where there is none.
InputError no_lung(const Place& option);

/// Throws InputErrors for all parameters of a lung that are fitted, held or have a prior in a scenario that
/// has no lung.
void require_lung_for(const FitDraft& draft, const std::vector<Prior>& priors, const Scenario& scenario);

}  // namespace trunk
