#pragma once

#include <string>
#include <vector>

#include "io/trace.hpp"

namespace trunk {

/// One continuous volume, up to a constant and a drift.
struct VolumeSignal {
  std::vector<double> time_s, volume_m3;  ///< one value a sample
  std::vector<std::string> notes;         ///< what was repaired
};

/// From a trace: single-sample spikes are replaced by the mean of their neighbours; a flow is integrated by
/// the trapezoidal rule from 0; a volume that jumps to 0 (the reset of ventilators and spirometers) is made
/// continuous. Throws InputError with the trace's source when all samples have one value.
VolumeSignal volume_signal(const Trace& trace);

}  // namespace trunk
