#pragma once

#include <string>
#include <vector>

#include "traces/trace.hpp"

namespace trunk {

/// A continuous volume, up to a constant and a drift.
struct VolumeSignal {
  std::vector<double> time_s, volume;  ///< [samples] volume in m3, for a belt in its own unit
  std::vector<std::string> notes;      ///< what was repaired, or looks odd
};

/// Returns the volume of a trace. Spikes of up to five samples and 0.1 s are replaced by a line. Pulses of
/// zero flow are bridged (zero_pulses). A flow is integrated from 0 by the trapezoidal rule. A volume that
/// jumps to 0 (the reset of ventilators and spirometers) is made continuous. A note says if many samples lie
/// at the highest value (for a flow, also at the lowest). Throws InputError if all samples have the same
/// value.
VolumeSignal volume_signal(const Trace& trace);

}  // namespace trunk
