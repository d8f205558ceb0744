#pragma once

#include <cstddef>
#include <span>

namespace trunk {

/// Returns whether the volume from one trough over a peak to the next is more than noise. Noise of a flow
/// sums up to a random walk, which rises and falls on every time scale, as the air around an open mask does.
/// A breath is smooth instead: its height is at least six times (three times if it has fewer than twelve
/// samples) what a random walk with its own fourth differences, at a sixteenth or at a thirty-second of its
/// length, would reach (our choice: walks reach one to three times that, and breaths twenty or more). A
/// ripple of the heart shows at one of the two at most. first < peak < last.
bool above_noise(std::span<const double> volume, std::size_t first, std::size_t peak, std::size_t last);

/// Returns the same for both lengths: what is small must stand out clearly.
bool clearly_above_noise(std::span<const double> volume, std::size_t first, std::size_t peak,
                         std::size_t last);

}  // namespace trunk
