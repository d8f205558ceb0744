#pragma once

#include <string>
#include <vector>

#include "traces/trace.hpp"

namespace trunk {

/// One continuous volume, up to a constant and a drift.
struct VolumeSignal {
  std::vector<double> time_s, volume;  ///< one value a sample; m3, of a belt in its own unit
  std::vector<std::string> notes;      ///< what was repaired, or looks odd
};

/// From a trace: spikes of up to five samples and 0.1 s are replaced by a line; a flow is integrated by the
/// trapezoidal rule from 0; a volume that jumps to 0 (the reset of ventilators and spirometers) is made
/// continuous. Samples that crowd at the highest value (of a flow: or the lowest) are noted with
/// their share. Throws InputError with the trace's source when all samples have one value.
VolumeSignal volume_signal(const Trace& trace);

}  // namespace trunk
