#include "traces/check_other.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "text/message_text.hpp"
#include "traces/flow_against_volume.hpp"

namespace trunk {
namespace {

constexpr double clear = 0.5, sure = 0.7, late_s = 0.1;
constexpr double usual_gain = 1.25, largest_gain = 2;

struct Pair {
  const ColumnName &flow, &volume;
  bool flow_is_signal;

  std::string names() const {
    return fmt::format("flow {} and volume {}", excerpt(flow.text), excerpt(volume.text));
  }
};

void turn(Trace& trace) {
  for (double& value : trace.value) value = -value;
}

// Lets the volume show the sign of the flow. => trace
void settle_sign(const FlowAgainstVolume& found, const Pair& pair, Trace& trace) {
  if (std::abs(found.along) < clear) return;
  const std::string flow = excerpt(pair.flow.text), volume = excerpt(pair.volume.text);
  if (found.along < 0 && trace.inverted_by_user) {
    trace.notes.push_back(
        fmt::format("--invert turns flow {} against volume {} (correlation {:.2f}): is it needed?", flow,
                    volume, found.along));
    return;
  }
  trace.sign = SignShownBy::volume;
  if (found.along > 0) return;
  turn(trace);
  trace.notes.push_back(
      fmt::format("flow {} is negative on inspiration and is turned: it runs against volume {} "
                  "(correlation {:.2f}; 0 would show nothing, -1 is clearest)",
                  flow, volume, found.along));
}

bool within(double gain, double limit) {
  return gain <= limit && gain >= 1 / limit;
}

// Returns the unit with which the flow, or the volume, would agree with the other column, or "".
std::string agreeing_unit(const Pair& pair, double gain, bool of_flow) {
  constexpr std::array flows{"L/s", "L/min", "ml/s"}, volumes{"ml", "L", "cl"};
  for (const char* name : of_flow ? flows : volumes) {
    const double size = unit_of(name)->to_si;
    if (within(of_flow ? gain * pair.flow.to_si / size : gain * size / pair.volume.to_si, usual_gain))
      return name;
  }
  return "";
}

void check_gain(double gain, const Pair& pair, bool unit_by_user, Trace& trace) {
  if (within(gain, usual_gain)) return;
  const std::string found =
      fmt::format("volume {} rises by {} what flow {} adds up to", excerpt(pair.volume.text),
                  gain < 1 ? fmt::format("1/{} of", number_text(1 / gain, 3))
                           : fmt::format("{} times", number_text(gain, 3)),
                  excerpt(pair.flow.text));
  if (within(gain, largest_gain) || unit_by_user) {
    trace.notes.push_back(found +
                          ": one of the two has another calibration or another unit than its name says");
    return;
  }
  std::string remedy;
  for (const bool of_signal : {true, false}) {
    const bool of_flow = of_signal == pair.flow_is_signal;
    const std::string unit = agreeing_unit(pair, gain, of_flow);
    if (!unit.empty())
      remedy += fmt::format("if the {} is in {}, {}; ", of_flow ? "flow" : "volume", unit,
                            of_signal ? "add --unit " + unit : "write that into its name");
  }
  const std::string signal = pair.flow_is_signal ? "flow" : "volume";
  throw InputError({trace.source}, found, "about the same, since one is the integral of the other",
                   fmt::format("{}if the {} is in {}, as its name says, confirm that with --unit", remedy,
                               signal, spoken_unit(pair.flow_is_signal ? pair.flow.unit : pair.volume.unit)));
}

}  // namespace

void check_other(Recording& recording, const TraceColumns& columns, const UsedSamples& used, Trace& trace) {
  if (trace.inverted_by_user) turn(trace);
  if (!columns.other) return;
  const bool flow_is_signal = trace.kind == SignalKind::flow;
  const ColumnName &signal = columns.all[columns.value], &other = columns.all[*columns.other];
  const Pair pair{flow_is_signal ? signal : other, flow_is_signal ? other : signal, flow_is_signal};
  const std::size_t chosen[] = {*columns.other};
  std::vector<double> beside = used.of(recording.read(chosen).values[0], trace.time_s.size());
  const bool scaled = other.quantity != Quantity::unknown && other.doubtful_unit().empty();
  if (scaled)
    for (double& v : beside) v *= other.to_si;
  const FlowAgainstVolume found = flow_is_signal ? flow_against_volume(trace.time_s, trace.value, beside)
                                                 : flow_against_volume(trace.time_s, beside, trace.value);
  if (!found.seen) return;
  if (flow_is_signal) settle_sign(found, pair, trace);
  if (std::abs(found.best) < clear) {
    if (scaled)
      trace.notes.push_back(
          fmt::format("{} do not go together (correlation {:.2f} at most): is each what its name says?",
                      pair.names(), std::abs(found.best)));
    return;
  }
  if (std::abs(found.lag_s) >= late_s)
    trace.notes.push_back(
        fmt::format("volume {} is {} by {:.2f} s against flow {}: channels of this file may not be "
                    "of one time",
                    excerpt(pair.volume.text), found.lag_s > 0 ? "late" : "early", std::abs(found.lag_s),
                    excerpt(pair.flow.text)));
  if (scaled && std::abs(found.best) >= sure) check_gain(found.gain, pair, columns.unit_by_user, trace);
}

}  // namespace trunk
