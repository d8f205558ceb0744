#pragma once

#include "breaths/segment.hpp"
#include "gates/gates.hpp"
#include "subject/subject_fit.hpp"

namespace trunk::test {

/// A fit of a recording as `trunk fit` makes it, but without profiles and without a joint region.
struct FittedTwin {
  Segmentation segmentation;
  SubjectFit fit;
  Ledger ledger{};
  Estimation estimation;
  FitResults results;

  FittedTwin(ScenarioFile file, Trace trace, FitPlan plan = {})
      : segmentation(segment_breaths(std::move(trace))),
        fit(std::move(file), {mean_breath(segmentation), 0.0, trace_signs(segmentation)}, briefly(plan)),
        estimation(fit.carry_out(ledger)),
        results(fit.results(estimation)) {}

 private:
  static FitPlan briefly(FitPlan plan) {
    plan.estimation.profiles = false;
    plan.estimation.surface_points = 0;
    plan.estimation.execution.threads = 1;
    return plan;
  }
};

}  // namespace trunk::test
