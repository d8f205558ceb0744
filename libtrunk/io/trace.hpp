#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trunk {

/// A belt measures a chest's circumference in units of its own: like a volume, up to an unknown factor.
enum class SignalKind { volume, flow, belt };

/// A measured breathing signal, one value a sample; all vectors with samples have the same length.
struct Trace {
  std::string source;  ///< file name, for messages
  SignalKind kind = SignalKind::volume;
  std::vector<double> time_s;      ///< strictly increasing
  std::vector<double> value;       ///< m3; flow (inspiration positive): m3/s; belt: as in the file
  std::vector<double> sigma_m3;    ///< standard deviation of the volume; empty when not given
  std::vector<std::string> notes;  ///< what was chosen or repaired, for the user
  std::string time_unit = "s";     ///< unit in the file: "s", "ms", "min"; for messages
  std::string value_unit = "ml";   ///< unit in the file: "ml", "L", "L_s", "L_min", "ml_s"
};

struct TraceOptions {
  std::string time_column;           ///< header of the time column; empty: time_s, time_ms or time_min
  std::string value_column;          ///< header of the signal, whatever its base name; empty: automatic
  std::optional<SignalKind> prefer;  ///< when both flow and volume exist; default: flow, see read_trace
};

/// Reads a breathing signal from a table in text (see DelimitedText for the format): a column
/// `time_s|time_ms| time_min`, one of `volume_ml|volume_L|flow_L_s|flow_L_min|flow_ml_s`, optionally
/// `sigma_ml`. Case does not matter, and "Time (s)" or "Flow [L/s]" are understood. Where both flow and
/// volume exist the flow is taken, as ventilators reset their volume at each breath; a note says so.
///
/// Bounds (our choice): 200 MB, 10 million rows, 1 MB a line. Throws InputError, one line with file and line
/// number, for everything that cannot be a recording: no such columns, a bad cell, time that does not
/// increase, a gap of more than 10 median steps and 0.25 s, fewer than 10 samples.
Trace read_trace(const std::filesystem::path& path, const TraceOptions& options = {});

}  // namespace trunk
