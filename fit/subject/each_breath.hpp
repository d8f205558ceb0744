#pragma once

#include "subject/subject_fit.hpp"

namespace trunk {

/// The muscle in one breath of a trace.
struct BreathRefit {
  std::size_t number = 0;  // counted from 1, as in the list of breaths
  double onset_s = 0.0, tidal_volume_m3 = 0.0;
  std::string status;  // that of status_of, or "failed"
  std::string error;   // why it failed
  Estimate muscle;     // NaN if the fit failed
  double nrmse = 0.0;
  std::size_t evaluations = 0;
  double latency_s = 0.0;  // wall time from the measured breath to its interval
};

/// Fits k_muscle alone to each kept breath (the paper's second stage), by Levenberg-Marquardt. All other
/// mechanical parameters stay as `e` found them for the mean breath. The plan of `fit` gives the timing of
/// each breath: from the trace, estimated along with k_muscle, or from the scenario. A search starts at the
/// k_muscle of the breath before, times the ratio of the tidal volumes. A breath that fails is a row that
/// says why. `report` is called with the number of breaths done. Throws Cancelled.
std::vector<BreathRefit> refit_each_breath(const SubjectFit& fit, const Estimation& e,
                                           const Segmentation& segmentation,
                                           const std::function<void(std::size_t)>& report = {});

}  // namespace trunk
