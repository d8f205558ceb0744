#pragma once

#include <memory>

#include "estimation/estimate.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Where the activation's timing comes from. joint: it is estimated along with the parameters and starts from
/// the trace; trace: a one-compartment model takes it from the trace, and it is held; scenario: it is the
/// scenario's.
enum class Timing { joint, trace, scenario };

/// How one subject is fitted.
struct FitPlan {
  std::vector<std::string> free;   // names; empty: k_elasticity and k_muscle (one number: k_muscle)
  std::vector<std::string> fixed;  // name=value or name=@file.h5
  std::vector<Prior> priors;
  Timing timing = Timing::joint;
  bool weighted = false;  // samples count by the deviation that the breath gives them
  EstimationOptions estimation;
};

/// What was measured of a subject: a breath, or its tidal volume alone.
struct Measurement {
  std::optional<MeasuredBreath> breath;
  double tidal_volume_m3 = 0.0;
};

/// A fit that is ready to be carried out. It cannot be moved, because its parts refer to each other.
class SubjectFit {
 public:
  /// Takes the timing from the breath, sets the fixed parameters (their files go to file.inputs) and sets up
  /// the search. Throws InputError if the plan contradicts itself or the scenario.
  SubjectFit(ScenarioFile file, Measurement measurement, FitPlan plan);
  SubjectFit(const SubjectFit&) = delete;

  /// Returns all that a simulation depends on beside the candidate, as a key for the ledger.
  std::string problem_text() const;
  Estimation carry_out(Ledger& ledger) const;

  /// Returns the scenario with the best parameters.
  ScenarioFile fitted(const Estimation& e) const;

  const ScenarioFile& file() const noexcept { return file_; }
  const Measurement& measurement() const noexcept { return measurement_; }
  const FitPlan& plan() const noexcept { return plan_; }
  const MeasuredCurve& measured_curve() const noexcept { return measured_curve_; }
  const SearchSpace& space() const noexcept { return *space_; }
  const Trunk& trunk() const noexcept { return trunk_; }

 private:
  ScenarioFile file_;
  Measurement measurement_;
  FitPlan plan_;
  MeasuredCurve measured_curve_;
  std::unique_ptr<const SearchSpace> space_;
  Trunk trunk_;
  std::size_t timed_ = 0;
};

/// Returns "converged", "not_identifiable" or "not_converged", as `fit --json` prints it.
std::string status_of(const Estimation& e);

}  // namespace trunk
