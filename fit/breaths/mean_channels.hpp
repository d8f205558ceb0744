#pragma once

#include <vector>

#include "breaths/mean_breath.hpp"

namespace trunk {

/// Returns the channels of a trace over its mean breath, of which the times and `used` are set.
///
/// The level at an end of expiration is the mean over 0.02 s on either side. An EMG that takes both signs is
/// raw: it is made positive and averaged over 0.1 s, without a lag. A breath counts if the channel has
/// numbers throughout, and if no swallow shows: oesophageal pressure then rises above the median of all
/// breaths by more than 4 times the median of such rises and by more than the swing of the median breath
/// (transdiaphragmatic pressure falls alike); this needs four breaths. sigma is the standard deviation over
/// breaths, or the noise of fewer than three, and at least 1 % of the swing. All numbers are our choice.
/// Nothing is filtered: what the heart adds differs from breath to breath, and the mean over n breaths holds
/// its n-th root. A note says how large it is.
///
/// Throws InputError if no breath counts.
std::vector<MeasuredChannel> mean_channels(const Segmentation& segmentation, const MeasuredBreath& mean);

}  // namespace trunk
