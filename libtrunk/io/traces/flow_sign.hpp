#pragma once

#include <vector>

namespace trunk {

/// Returns the correlation of a flow with the rise of a volume over steps of 0.1 s; 0 if there are too few
/// samples with numbers. 1: they agree; -1: one of them is upside down. Neither needs a unit. Steps are
/// limited to three times their median size, so that resets of the volume hardly count (our choice).
double flow_along_volume(const std::vector<double>& time_s, const std::vector<double>& flow,
                         const std::vector<double>& volume);

}  // namespace trunk
