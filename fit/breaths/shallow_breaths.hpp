#pragma once

#include <span>
#include <vector>

#include "breaths/turning_points.hpp"

namespace trunk {

/// Returns the turning points of breathing together with those of breaths that are much smaller than usual:
/// from 0.08 of the median rise on, so that none of a tenth is missed. `turns` are those of
/// breath_turning_points in the same volume.
///
/// A smaller rise may also be a part of the breath around it, as a swallow, a step of the expiration or a
/// heartbeat. It is a breath of its own if it is 0.3 of what is usual nearby; or if it returns to the level
/// from which it began; or if the two cycles that it makes of one both last 0.6 of the usual cycle, as they
/// do where the base line wanders. It must stand out of the noise (clearly_above_noise) and last an eighth of
/// the usual cycle, but not four times as long. All limits are our choice.
std::vector<TurningPoint> with_shallow_breaths(std::span<const double> volume,
                                               std::vector<TurningPoint> turns);

}  // namespace trunk
