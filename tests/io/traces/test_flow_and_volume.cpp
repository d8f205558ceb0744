#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/traces.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

// Flow and volume of breaths of 2 V over 4 s, with closed forms; the volume may be late.
std::string table(const std::string& names, double flow_factor, double volume_factor, double late_s = 0) {
  constexpr double w = std::numbers::pi / 2;
  std::string text = "time_s," + names + "\n";
  for (int i = 0; i < 2400; ++i) {
    const double t = 0.01 * i, volume = 0.25 * (1 - std::cos(w * (t - late_s)));
    text += std::to_string(t) + "," + std::to_string(flow_factor * 0.25 * w * std::sin(w * t)) + "," +
            std::to_string(volume_factor * volume) + "\n";
  }
  return text;
}

std::string notes_of(const std::string& text, const TraceOptions& options = {}) {
  std::string all;
  for (const std::string& note : trace_of(text, options).notes) all += note + "\n";
  return all;
}

TraceOptions as_volume() {
  TraceOptions options;
  options.kind = SignalKind::volume;
  return options;
}

}  // namespace

TEST_CASE("A flow and a volume that agree say nothing", "[faults]") {
  CHECK_THAT(notes_of(table("flow_L_s,volume_ml", 1, 1000)),
             !Contains("volume_ml' rises") && !Contains("late"));
  CHECK(notes_of(table("flow_L_s,volume_ml", 1.1, 1000), as_volume()).empty());
  CHECK_THAT(notes_of(table("flow_L_s,volume", 1, 7)), !Contains("rises by"));  // no unit, no size
}

TEST_CASE("A wrong unit of a flow or a volume shows beside the other", "[faults]") {
  const std::string minutes = table("flow_L_s,volume_ml", 60, 1000);
  CHECK_THAT(trace_error(minutes),
             Contains("volume 'volume_ml' rises by 1/60 of what flow 'flow_L_s' adds up to") &&
                 Contains("if the flow is in L/min, add --unit L/min") &&
                 Contains("is in L/s, as its name says, confirm that with --unit"));
  TraceOptions told;
  told.unit = "L/min";
  CHECK_THAT(notes_of(minutes, told), !Contains("rises by"));
  told.unit = "L/s";
  CHECK_THAT(notes_of(minutes, told), Contains("one of the two has another calibration or another unit"));
  CHECK_THAT(trace_error(table("flow_L_s,volume_L", 1, 1000)),
             Contains("rises by 1000 times what flow") &&
                 Contains("if the volume is in ml, write that into its name"));
  CHECK_THAT(trace_error(table("flow_L_s,volume_ml", 1, 1), as_volume()),
             Contains("if the volume is in L, add --unit L"));
  CHECK_THAT(trace_error(table("flow_L_s,volume_ml", 1, 100)), Contains("rises by 1/10 of"));
}

TEST_CASE("Another calibration and a delay between flow and volume are told", "[faults]") {
  CHECK_THAT(notes_of(table("flow_L_s,volume_ml", 1.5, 1000)),
             Contains("rises by 1/1.5 of what flow 'flow_L_s'"));
  const std::string late = notes_of(table("flow_L_s,volume_ml", 1, 1000, 0.3));
  CHECK_THAT(late, Contains("volume 'volume_ml' is late by 0.30 s against flow") && !Contains("rises by"));
  CHECK_THAT(notes_of(table("flow_L_s,volume_ml", 1, 1000, -0.3)), Contains("is early by 0.30 s"));
  // A quarter of a cycle late, by more than is looked for: they go together at no lag.
  CHECK_THAT(notes_of(table("flow_L_s,volume_ml", 1, 1000, 1)), !Contains("turned"));
}

TEST_CASE("A flow and a volume that have nothing to do with each other are told", "[faults]") {
  std::string text = "time_s,flow_L_s,volume_ml\n";
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.01 * i;
    text += std::to_string(t) + "," + std::to_string(0.4 * std::sin(1.5 * t)) + "," +
            std::to_string(500 * std::sin(2.6 * t)) + "\n";
  }
  CHECK_THAT(notes_of(text), Contains("flow 'flow_L_s' and volume 'volume_ml' do not go together"));
}
