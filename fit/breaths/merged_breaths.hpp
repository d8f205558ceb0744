#pragma once

#include <span>
#include <vector>

#include "breaths/turning_points.hpp"

namespace trunk {

/// Returns turning points with breaths parted that a wandering base line has merged: it may rise so fast that
/// the volume hardly falls between two breaths. A cycle from trough to trough that lasts more than 1.5 usual
/// ones is searched again, after its mean over a usual cycle around each sample is removed. A breath is
/// parted if the volume falls between them, and if both cycles last 0.6 to 2 usual ones, rise or fall by 0.4
/// of the usual rise, and rise by 0.35 of it above that mean (our choice; a long pause makes a rise of 0.2).
std::vector<TurningPoint> with_merged_parted(std::span<const double> volume, std::vector<TurningPoint> turns);

}  // namespace trunk
