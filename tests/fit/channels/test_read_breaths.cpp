#include "channels/read_breaths.hpp"

#include <cmath>

#include "errors/input_error.hpp"
#include "gates/gates.hpp"
#include "support/catch.hpp"
#include "support/lung_breather.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::string refusal_of(const Trace& trace) {
  try {
    breaths_of(trace);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void turn(std::vector<double>& values) {
  for (double& v : values) v = -v;
}

/// A breath whose shape says nothing about which way is up.
LungBreather symmetric() {
  LungBreather who;
  who.inspiration = who.expiration = 1.9, who.pause = 0.02;
  return who;
}

TraceChannel across(const Trace& trace) {
  TraceChannel channel{ChannelKind::transdiaphragmatic, "pdi", "cmH2O", {}};
  for (std::size_t i = 0; i < trace.time_s.size(); ++i)
    channel.value.push_back(trace.channels[1].value[i] - trace.channels[0].value[i]);
  return channel;
}

bool noted(const Segmentation& s, const std::string& part) {
  return std::any_of(s.notes.begin(), s.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

bool asks(const Segmentation& s) {
  const auto notes = screened(s, std::nullopt).notes;
  return std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("which way is up") != std::string::npos;
  });
}

}  // namespace

TEST_CASE("Pleural pressure settles the sign of a flow whose shape leaves it open", "[channels]") {
  Trace trace = recorded(symmetric());
  const Segmentation upright = breaths_of(trace);
  CHECK_FALSE(asks(upright));
  CHECK_FALSE(noted(upright, "turned"));
  Trace flow_alone = trace;
  flow_alone.channels.clear();
  CHECK(asks(breaths_of(flow_alone)));

  turn(trace.value);
  const Segmentation turned = breaths_of(trace);
  CHECK(noted(turned, "the signal is turned, since oesophageal pressure 'poes' would rise on inspiration"));
  CHECK_FALSE(asks(turned));
  REQUIRE(turned.volume_m3.size() == upright.volume_m3.size());
  for (std::size_t i = 0; i < turned.volume_m3.size(); ++i)
    REQUIRE(turned.volume_m3[i] == Approx(upright.volume_m3[i]).margin(1e-9));
}

TEST_CASE("A pleural pressure that moves the wrong way is named where the signal is upright", "[channels]") {
  Trace trace = recorded({});
  turn(trace.channels[0].value);
  const std::string error = refusal_of(trace);
  CHECK_THAT(error, StartsWith("lung.csv: oesophageal pressure 'poes' moves the wrong way: it rises by"));
  CHECK_THAT(error, Contains("--invert-channel poes") && Contains("--invert") && Contains("--poes none"));
  Trace open = recorded(symmetric());
  turn(open.channels[0].value);
  for (const bool by_user : {true, false}) {
    CAPTURE(by_user);
    open.inverted_by_user = by_user;  // or the volume beside the flow
    open.sign = by_user ? SignShownBy::shape : SignShownBy::volume;
    CHECK_THAT(refusal_of(open), Contains("moves the wrong way"));
  }
}

TEST_CASE("A ventilator's pleural pressure may rise if its airway pressure is there", "[channels]") {
  LungBreather who;
  who.elastance = -5, who.resistance = 0;  // the chest wall is passive: pleural pressure follows the volume
  Trace trace = recorded(who);
  CHECK_THAT(refusal_of(trace), Contains("--paw"));
  TraceChannel airway{ChannelKind::airway, "paw", "cmH2O", {}};
  double volume = 0;
  for (const double flow : trace.value) {
    volume += litres_per_m3 * flow / who.rate;
    airway.value.push_back(Pa_per_cmH2O * (5 + 15 * volume + 8 * litres_per_m3 * flow));
  }
  trace.channels.push_back(airway);
  CHECK(refusal_of(trace).empty());
}

TEST_CASE("A swing that no human has is refused by name, with the unit that would explain it", "[channels]") {
  struct Case {
    double factor;
    const char* hint;
  };
  const auto [factor, hint] = GENERATE(values<Case>(
      {{98.0665, "if it is in Pa, give --pressure-unit Pa"}, {1 / 1000.0, "check its unit"}, {60, "Pa"}}));
  Trace trace = recorded({});
  for (double& v : trace.channels[0].value) v *= factor;
  const std::string error = refusal_of(trace);
  CAPTURE(factor, error);
  CHECK_THAT(error, Contains("oesophageal pressure 'poes' swings by") && Contains("0.05 to 150 cmH2O"));
  CHECK_THAT(error, Contains(hint) && Contains("--poes none"));
}

TEST_CASE("One pressure cannot be both above and below the diaphragm", "[channels]") {
  Trace trace = recorded({});
  std::vector<double>& gastric = trace.channels[1].value;
  gastric = trace.channels[0].value;
  for (double& v : gastric) v += 900.0;  // another level says nothing
  CHECK_THAT(refusal_of(trace),
             Contains("'pga' is the same as oesophageal pressure 'poes'") && Contains("--pga none"));
  for (double& v : gastric) v *= 1.2;
  CHECK(refusal_of(trace).empty());
}

TEST_CASE("A gastric pressure that falls on inspiration is named, and may be so", "[channels]") {
  Trace trace = recorded({});
  CHECK_FALSE(noted(breaths_of(trace), "gastric pressure"));
  turn(trace.channels[1].value);
  const Segmentation s = breaths_of(trace);
  CHECK(noted(s, "gastric pressure 'pga' falls as the volume rises (correlation -"));
  CHECK(noted(s, "--invert-channel pga turns it"));
}

TEST_CASE("Transdiaphragmatic pressure must be gastric less pleural pressure", "[channels]") {
  Trace trace = recorded({});
  trace.channels.push_back(across(trace));
  CHECK(refusal_of(trace).empty());
  SECTION("another gain") {
    for (double& v : trace.channels[2].value) v *= 1.4;
    CHECK_THAT(refusal_of(trace),
               Contains("'pdi' is not gastric 'pga' less oesophageal 'poes': they differ by") &&
                   Contains("--pdi none"));
  }
  SECTION("the other sign") {
    turn(trace.channels[2].value);
    CHECK_THAT(refusal_of(trace), Contains("its sign is reversed: --invert-channel pdi"));
    trace.channels.erase(trace.channels.begin());
    CHECK_THAT(refusal_of(trace), Contains("falls by") && Contains("--invert-channel pdi"));
  }
  SECTION("a constant offset does not matter") {
    for (double& v : trace.channels[2].value) v += 10 * Pa_per_cmH2O;
    CHECK(refusal_of(trace).empty());
  }
}

TEST_CASE("Excursions and EMG that cannot be are refused by name", "[channels]") {
  Trace trace = recorded({});
  const std::size_t n = trace.time_s.size();
  trace.channels = {{ChannelKind::emg, "emg", "", std::vector<double>(n, 0.3)}};
  CHECK_THAT(refusal_of(trace), Contains("EMG 'emg' does not change") && Contains("--emg none"));
  trace.channels = {{ChannelKind::excursion, "dome", "mm", std::vector<double>(n, 0.01)}};
  CHECK_THAT(refusal_of(trace), Contains("'dome' moves by 0 mm") && Contains("1 to 150 mm"));
}
