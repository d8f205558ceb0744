#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "traces/channel.hpp"

namespace trunk {

/// A belt measures the circumference of the chest in its own unit. It is proportional to a volume by an
/// unknown factor.
enum class SignalKind { volume, flow, belt };

/// What shows which way a signal goes up, beside its shape.
enum class SignShownBy { shape, volume, pressure };

/// A measured breathing signal. All vectors of samples have the same length.
struct Trace {
  std::string source;  ///< file name, for messages
  SignalKind kind = SignalKind::volume;
  std::vector<double> time_s;      ///< strictly increasing
  std::vector<double> value;       ///< m3; flow (inspiration positive): m3/s; belt: as in the file
  std::vector<double> sigma_m3;    ///< standard deviation of the volume; empty if it is not given
  std::vector<std::string> notes;  ///< messages for the user about choices and repairs
  std::string time_unit = "s";     ///< unit in the file: "s", "ms", "min"; for messages
  std::string value_unit =
      "ml";  ///< unit in the file: "ml", "L", "L_s", "L_min", "ml_s"; belt: its own or ""
  std::vector<TraceChannel> channels;     ///< at most one of each kind; none: the signal alone
  SignShownBy sign = SignShownBy::shape;  ///< volume: a flow goes with the volume beside it
  bool inverted_by_user = false;
  bool drift_by_user = false;           ///< the user says that a drift as large as a breath is one
  std::optional<double> excursion_m{};  ///< of a dome from end-expiration to end-inspiration, if one number
};

/// The choices of a user. A column (channel, variable) is given by its name, by its name without the unit, or
/// by its number from 1.
struct TraceOptions {
  std::string time_column;         ///< empty: automatic
  std::string value_column;        ///< empty: automatic
  std::optional<SignalKind> kind;  ///< of the signal; default: from its unit and name
  std::string unit;                ///< of the signal, "L/s"; empty: as in the file
  std::string time_unit;           ///< "ms"; empty: as in the file, or else s
  double rate_hz = 0;              ///< samples per second if there are no times; 0: as in the file
  bool invert = false;             ///< the sign of the signal is turned
  bool remove_drift = false;       ///< a drift as large as a breath is one
  std::string encoding;            ///< of a text, as iconv calls it; empty: automatic
  std::size_t block = 0;           ///< part of a recording with interruptions, from 1; 0: the longest
  ChannelOptions channels;
};

}  // namespace trunk
