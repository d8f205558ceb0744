#pragma once

#include <filesystem>

#include "traces/trace.hpp"

namespace trunk {

/// Reads a breathing signal from a text table, a text of LabChart or AcqKnowledge, a MAT-file or EDF/BDF (see
/// open_recording).
///
/// The documented columns are `time_s|time_ms|time_min`, `volume_ml|volume_L|flow_L_s|flow_L_min|flow_ml_s`
/// and optionally `sigma_ml`, also written as "Time (s)" or "Flow [L/s]". If they are missing, columns with
/// synonyms in several languages are used (see role_of), and a note names them. If there is no volume or
/// flow, a belt is used. If there are both, the flow is used, since ventilators reset the volume at each
/// breath; a note says so.
///
/// Channels beside the signal are chosen as choose_channels describes and read by read_channel. A flow and a
/// volume of one file are held against each other (see check_other). The sign of a signal is turned before
/// that if `options.invert`, and then stays.
///
/// If channels at different rates share the rows of a table, those without the signal are left out (see
/// RawSamples). Two faults are repaired, with a note. Up to 0.25 s of samples without a number are
/// interpolated, or removed at either end. Equal times of a coarse clock are spread evenly. Another note
/// reports a rate below 10 or above 2000 samples per second.
///
/// The limits are our choice: 200 MB of text, 10 million samples, 1 MB per line. Throws InputErrors with file
/// and line if columns are missing, if the unit of one is not clear, if more samples have no number, if time
/// does not increase, if a gap is longer than both 10 median steps and 0.25 s, or if there are fewer than 10
/// samples or fewer than 4 per second.
Trace read_trace(const std::filesystem::path& path, const TraceOptions& options = {});

}  // namespace trunk
