#pragma once

#include <memory>

#include "breaths/mean_breath.hpp"
#include "estimation/estimate.hpp"
#include "gates/gates.hpp"
#include "problem/scale_priors.hpp"
#include "scenarios/read_scenario.hpp"
#include "subject/fit_draft.hpp"
#include "verdict/fit_results.hpp"

namespace trunk {

/// Where the activation's timing comes from. joint: it is estimated along with the parameters, and so is the
/// activation's shape; trace: one compartment with straight lines takes it from the trace, and it is held;
/// scenario: it is the scenario's.
enum class Timing { joint, trace, scenario };

/// How one subject is fitted.
struct FitPlan {
  std::vector<std::string> free;   // names; empty: k_elasticity and k_muscle (one number: k_muscle)
  std::vector<std::string> fixed;  // name=value or name=@file.h5
  std::vector<Prior> priors;
  Timing timing = Timing::joint;
  bool straight = false;  // the activation is assumed to consist of straight lines
  bool weighted = false;  // samples count by the deviation that the breath gives them
  int starts = 12;        // of the compartment
  EstimationOptions estimation;
};

/// What was measured of a subject: a breath, or its tidal volume alone.
struct Measurement {
  std::optional<MeasuredBreath> breath;
  double tidal_volume_m3 = 0.0;
  std::optional<TraceSigns> signs{};  // of the whole recording
};

/// A fit that is ready to be carried out. It cannot be moved, because its parts refer to each other.
class SubjectFit {
 public:
  /// Sets the fixed parameters (their files go to file.inputs), lets one compartment find where the search
  /// begins, and sets up the search. The breath repeats, unless the scenario was told `--set
  /// time.start=rest`. Throws InputError if the plan contradicts itself or the scenario.
  SubjectFit(ScenarioFile file, Measurement measurement, FitPlan plan);
  SubjectFit(const SubjectFit&) = delete;

  /// Returns all that a simulation depends on beside the candidate, as a key for the ledger.
  std::string problem_text() const;
  Estimation carry_out(Ledger& ledger) const;
  /// Returns values, intervals and grades. It simulates a few breaths.
  FitResults results(const Estimation& e) const;

  /// Returns the scenario with the best parameters.
  ScenarioFile fitted(const Estimation& e) const;

  const ScenarioFile& file() const noexcept { return file_; }
  const Measurement& measurement() const noexcept { return measurement_; }
  const FitPlan& plan() const noexcept { return plan_; }
  const MeasuredCurve& measured_curve() const noexcept { return measured_curve_; }
  const Screening& screening() const noexcept { return screening_; }
  const SearchSpace& space() const noexcept { return *space_; }
  const Trunk& trunk() const noexcept { return trunk_; }
  /// Returns `count` candidates as the posterior has them. The estimation is one of this fit.
  std::vector<Candidate> draws(const Estimation& estimation, const Posterior& posterior,
                               std::size_t count) const;
  const std::vector<ScalePrior>& scale() const noexcept { return scale_; }
  const std::vector<LocalSearch>& compartment_searches() const noexcept { return searches_; }  // best first

 private:
  /// Returns whether the pressure of the airway changes in the course of a breath, so that a machine may
  /// breathe.
  bool driven_by_airway() const;
  void give_lung();
  void take_scale(FitDraft& draft);
  Knowledge knowledge_of(bool shaped) const;
  void begin_with_compartment(const FitDraft& draft);
  void choose_step();
  void calibrate_compartment(const FitDraft& draft);
  FitProblem problem() const;

  ScenarioFile file_;
  Measurement measurement_;
  FitPlan plan_;
  MeasuredCurve measured_curve_;
  std::unique_ptr<const SearchSpace> space_;
  Trunk trunk_;
  Parameters<double> begin_;  // of the scenario, before the compartment finds better ones
  TrunkAsCompartment compartment_;
  Knowledge knowledge_;
  std::vector<ScalePrior> scale_;  // what is known of forces; empty: the volume alone, and no lung
  double correlation_ = 0.0;       // of the noise of neighbouring samples; 0: as in a fit of the shape
  Screening screening_;
  std::vector<LocalSearch> searches_;
  std::optional<StraightActivation> straight_;
};

/// Returns "converged", "not_identifiable" or "not_converged", as `fit --json` prints it.
std::string status_of(Grade grade);

}  // namespace trunk
