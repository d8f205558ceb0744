#pragma once

#include <memory>

#include "estimation/estimate.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Where the activation's timing comes from: estimated along with the parameters, from the trace as a start;
/// from the trace by a one-compartment model and then held; from the scenario.
enum class Timing { joint, trace, scenario };

/// What a user asks of the fit of one subject.
struct FitPlan {
  std::vector<std::string> free;   // names; empty: k_elasticity and k_muscle (one number: k_muscle)
  std::vector<std::string> fixed;  // name=value or name=@file.h5
  std::vector<Prior> priors;
  Timing timing = Timing::joint;
  bool weighted = false;  // by the breath's own deviation of each sample
  EstimationOptions estimation;
};

/// What a subject brings: a measured breath, or its tidal volume alone.
struct Measurement {
  std::optional<MeasuredBreath> breath;
  double tidal_volume_m3 = 0.0;
};

/// A fit ready to be carried out. Not to be moved: its parts refer to each other.
class SubjectFit {
 public:
  /// Takes the timing from the breath, applies what is fixed (files go to file.inputs), sets up the search.
  /// Throws InputError on anything that makes no sense.
  SubjectFit(ScenarioFile file, Measurement measurement, FitPlan plan);
  SubjectFit(const SubjectFit&) = delete;

  /// All that a simulation depends on beside the candidate, for the ledger.
  std::string problem_text() const;
  Estimation carry_out(Ledger& ledger) const;

  /// The scenario with the best parameters.
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

/// "converged", "not_identifiable" or "not_converged", as in `fit --json`.
std::string status_of(const Estimation& e);

}  // namespace trunk
