#pragma once

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

}  // namespace trunk
