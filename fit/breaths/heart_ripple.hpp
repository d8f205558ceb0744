#pragma once

#include <optional>
#include <span>
#include <vector>

#include "breaths/landmarks.hpp"

namespace trunk {

/// What the heart adds to a volume.
struct HeartRipple {
  double frequency_hz = 0;
  double amplitude = 0;        ///< of its first harmonic, root mean square over time; in the volume's unit
  std::vector<double> volume;  ///< [samples] what it adds
};

/// Returns the ripple of the heart in a volume whose breaths are known; nothing if there is none.
///
/// What is left of the volume after its own mean breath is removed has a line in its spectrum, at 0.6 to 3.5
/// Hz and above twice the rate of breathing. The line stands eight times above the median within 0.6 Hz, and
/// its amplitude is 0.4 to 10 % of a tidal volume (our choice). Amplitude and phase are followed over four
/// beats, so that the rate may vary. A second and a third harmonic are added if they stand out as well. At
/// least five breaths are needed. A mean of few breaths keeps a part of the ripple, so the mean breath is
/// taken again from the volume without it, several times.
std::optional<HeartRipple> heart_ripple(std::span<const double> time_s, std::span<const double> volume,
                                        const Landmarks& marks, double drift);

}  // namespace trunk
