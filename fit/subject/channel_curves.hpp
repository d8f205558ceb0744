#pragma once

#include "results/records.hpp"
#include "subject/subject_fit.hpp"

namespace trunk {

/// Returns every channel of the mean breath beside what the trunk says of it at the best parameters. The
/// model has what its fit lets a channel have beside it, see nuisance_of: an offset, a drift, or the gain and
/// the delay of an EMG. The model of an airway pressure is the one that drove it. The model is empty if the
/// trunk does not complete its breath, and for an EMG that falls as the activation rises. It simulates one
/// breath.
std::vector<FitRecord::Channel> channel_curves(const SubjectFit& fit, const Estimation& estimation);

}  // namespace trunk
