#pragma once

#include "subject/subject_fit.hpp"

namespace trunk {

/// The muscle in one breath of a trace.
struct BreathRefit {
  std::size_t number = 0;  // counted from 1, as in the list of breaths
  double onset_s = 0.0, tidal_volume_m3 = 0.0;
  std::string status;  // as status_of, or "failed"
  std::string error;   // why it failed
  Estimate muscle;     // NaN where it failed
  double nrmse = 0.0;
  std::size_t evaluations = 0;
  double latency_s = 0.0;  // wall time from the measured breath to its interval
};

/// The paper's second stage: breath by breath, k_muscle alone is fitted (Levenberg-Marquardt), everything
/// else mechanical held at what `e` found for the mean breath. Each breath has its own timing, as the plan of
/// `fit` says: from the trace, estimated along with k_muscle or the scenario's. A search starts at the
/// k_muscle of the breath before, times the ratio of tidal volumes. Kept breaths only; one that fails is a
/// row that says why. `report` is told the breaths done. Throws Cancelled.
std::vector<BreathRefit> refit_each_breath(const SubjectFit& fit, const Estimation& e,
                                           const Segmentation& segmentation,
                                           const std::function<void(std::size_t)>& report = {});

}  // namespace trunk
