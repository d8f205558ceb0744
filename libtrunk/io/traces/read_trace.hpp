#pragma once

#include <filesystem>

#include "traces/trace.hpp"

namespace trunk {

/// Reads a breathing signal from a table in text, a MAT-file or EDF/BDF (see open_recording). Automatic are
/// the columns `time_s|time_ms|time_min`, `volume_ml|volume_L|flow_L_s|flow_L_min|flow_ml_s` and optionally
/// `sigma_ml`, also as "Time (s)" or "Flow [L/s]"; else those that say the same in other words or languages
/// (see role_of), which a note tells; else a belt. Where both flow and volume exist the flow is taken, as
/// ventilators reset their volume at each breath; a note says so.
///
/// Repaired, with a note: samples without a number where they miss up to 0.25 s (interpolated; cut off at
/// either end), times of a resolution so coarse that samples share them (spread evenly). Noted: less than 10
/// or more than 2000 samples a second.
///
/// Bounds (our choice): 200 MB of text, 10 million samples, 1 MB a line. Throws InputError, one line with
/// file and line number, for everything that cannot be a recording: no such columns, more samples without a
/// number, time that does not increase, a gap of more than 10 median steps and 0.25 s, fewer than 10 samples
/// or than 4 a second; InputErrors where there are several.
Trace read_trace(const std::filesystem::path& path, const TraceOptions& options = {});

}  // namespace trunk
