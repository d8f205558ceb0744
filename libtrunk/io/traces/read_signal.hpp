#pragma once

#include <filesystem>
#include <string>

#include "traces/trace.hpp"

namespace trunk {

/// How to read the user's signal: which columns, in which units, with which sign, and which part of which
/// file.
struct SignalOptions {
  std::string time, signal, flow, volume, belt;  ///< columns; at most one of the last four is given
  std::string unit, time_unit;
  double rate_hz = 0;
  bool invert = false, remove_drift = false;
  std::string encoding;
  std::size_t block = 0;
  ChannelOptions channels;
};

/// Returns the trace; throws InputError as read_trace.
Trace read_signal(const std::filesystem::path& path, const SignalOptions& options);

}  // namespace trunk
