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
  std::string value_unit =
      "ml";  ///< unit in the file: "ml", "L", "L_s", "L_min", "ml_s"; belt: its own, or ""
};

/// Columns (channels, variables) are given by their name, by their name without its unit, or by their number
/// from 1.
struct TraceOptions {
  std::string time_column;         ///< empty: automatic
  std::string value_column;        ///< empty: automatic
  std::optional<SignalKind> kind;  ///< of the signal; default: by its unit and name
  std::string unit;                ///< of the signal, "L/s"; empty: as the file says
  std::string time_unit;           ///< "ms"; empty: as the file says, else s
  double rate_hz = 0;              ///< samples a second, where there are no times; 0: as the file says
};

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
