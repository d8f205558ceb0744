#include "traces/read_signal.hpp"

#include "traces/read_trace.hpp"

namespace trunk {
namespace {

TraceOptions trace_options(const SignalOptions& given) {
  TraceOptions options;
  options.time_column = given.time;
  options.unit = given.unit;
  options.time_unit = given.time_unit;
  options.rate_hz = given.rate_hz;
  options.invert = given.invert;
  options.remove_drift = given.remove_drift;
  options.encoding = given.encoding;
  options.block = given.block;
  options.channels = given.channels;
  if (!given.flow.empty()) options.kind = SignalKind::flow;
  if (!given.volume.empty()) options.kind = SignalKind::volume;
  if (!given.belt.empty()) options.kind = SignalKind::belt;
  options.value_column = given.signal + given.flow + given.volume + given.belt;  // one of them
  return options;
}

}  // namespace

Trace read_signal(const std::filesystem::path& path, const SignalOptions& options) {
  return read_trace(path, trace_options(options));
}

}  // namespace trunk
