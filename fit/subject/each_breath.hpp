#pragma once

#include "breaths/segment.hpp"
#include "subject/subject_fit.hpp"

namespace trunk {

/// The muscle in one breath of a trace.
struct BreathRefit {
  std::size_t number = 0;  // counted from 1, as in the list of breaths
  double onset_s = 0.0, tidal_volume_m3 = 0.0;
  std::string status;  // "converged" or "failed"
  std::string error;   // why it failed
  Estimate muscle;     // NaN if the fit failed
  double nrmse = 0.0;
  std::size_t evaluations = 0;  // simulations of this breath
  double latency_s = 0.0;       // wall time from the measured breath to its interval
};

/// Fits k_muscle alone to each kept breath of a recording (the paper's second stage). The breaths are one
/// chain: each starts with what the one before has left, and its activation cuts the tail of that. Before the
/// first breath the mean breath repeats. All other mechanical parameters stay as `e` found them, and so does
/// the shape of the activation; its rise is stretched to the inspiration of each breath, its falls to the
/// expiration (unless the timing is the scenario's). Breaths that are not kept are simulated too, as a part
/// of the chain.
///
/// A segmented trace is 0 at both ends of every breath. So the line between the same two moments is taken off
/// the model too: the level at which a breath begins then does not matter, and no baseline is needed.
///
/// A breath that fails is a row that says why; the chain begins anew after it. `report` is called with the
/// number of breaths done. Throws Cancelled, and InputError if the trunk follows courses of a single breath.
std::vector<BreathRefit> refit_each_breath(const SubjectFit& fit, const Estimation& e,
                                           const Segmentation& segmentation,
                                           const std::function<void(std::size_t)>& report = {});

}  // namespace trunk
