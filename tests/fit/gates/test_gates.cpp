#include "gates/gates.hpp"

#include <filesystem>
#include <set>

#include "support/breath_records.hpp"
#include "support/breathers.hpp"
#include "support/catch.hpp"
#include "support/shared_data.hpp"
#include "traces/read_trace.hpp"

using namespace trunk;

namespace {

constexpr double adult_m3 = 4760e-6;

std::set<std::string> fired(const Trace& trace, std::optional<double> end_expiratory_m3 = adult_m3) {
  std::set<std::string> names;
  for (const Gate& gate : screened(segment_breaths(trace), end_expiratory_m3).gates) names.insert(gate.name);
  return names;
}

// The volume of a flow, with white noise as of a spirometer.
Trace spirometer(const Trace& flow, double noise_m3) {
  test::Random random(11);
  Trace trace = flow;
  trace.kind = SignalKind::volume, trace.value_unit = "ml";
  double volume = 0;
  for (std::size_t i = 0; i < flow.value.size(); ++i) {
    if (i > 0) volume += 0.5 * (flow.value[i - 1] + flow.value[i]) * (flow.time_s[i] - flow.time_s[i - 1]);
    trace.value[i] = volume + noise_m3 * random.normal();
  }
  return trace;
}

Trace upside_down(Trace trace) {
  for (double& v : trace.value) v = -v;
  return trace;
}

test::Breather breather(const test::MuscleShape& activation, double recoil_s, double period_s) {
  test::Breather who;
  who.activation = activation, who.recoil_s = recoil_s, who.period_s = period_s;
  return who;
}

// Signs that fire nothing.
TraceSigns no_signs() {
  TraceSigns signs;
  signs.orientation = {-0.8, 0.05, Upright::yes, {0.5, 0.3, 4}};
  signs.tidal_volume_m3 = 500e-6, signs.inspiration_s = 1.6, signs.step_s = 0.01, signs.breaths = 12;
  return signs;
}

std::string only_gate(const TraceSigns& signs, std::optional<double> end_expiratory_m3 = adult_m3) {
  const Screening screening = screened(signs, end_expiratory_m3);
  return screening.gates.size() == 1 ? screening.gates.front().name
                                     : std::to_string(screening.gates.size()) + " gates";
}

}  // namespace

TEST_CASE("Every limit of a gate separates", "[unit][gates]") {
  TraceSigns signs = no_signs();
  CHECK(only_gate(signs) == "0 gates");
  CHECK(screened(signs, adult_m3).notes.empty());
  SECTION("machine_driven") {
    signs.orientation.flow = {0.11, 0.10, 4};
    CHECK(only_gate(signs) == "0 gates");
    signs.orientation.flow = {0.09, 0.10, 4};
    CHECK(only_gate(signs) == "machine_driven");
    CHECK_THAT(screened(signs, adult_m3).gates.front().sentence,
               StartsWith("not driven by a muscle?") && Contains("flow is there within 90 ms"));
    signs.orientation.flow = {0.16, 0.09, 4};
    CHECK(only_gate(signs) == "machine_driven");
    signs.orientation.flow = {0.18, 0.09, 4};
    CHECK(only_gate(signs) == "0 gates");
    signs.orientation.flow = {0.11, 0.03, 1};  // an infant's breath is short
    CHECK(only_gate(signs) == "0 gates");
    signs.orientation.flow = {0, 0.09, 4};  // noise hides it
    CHECK(only_gate(signs) == "0 gates");
  }
  SECTION("subject_size") {
    signs.tidal_volume_m3 = 96e-6;
    CHECK(only_gate(signs) == "0 gates");
    signs.tidal_volume_m3 = 94e-6;
    CHECK(only_gate(signs) == "subject_size");
    CHECK(only_gate(signs, std::nullopt) == "0 gates");
    CHECK_THAT(screened(signs, adult_m3).gates.front().sentence,
               Contains("94 ml is 2 %") && Contains("this trunk is an adult's of 4760 ml"));
    signs.tidal_volume_m3 = 3850e-6;
    CHECK(only_gate(signs) == "subject_size");
    CHECK_THAT(subject_size(200e-6, 200e-6)->sentence, Contains("this trunk is one of 200 ml"));
  }
  SECTION("wander") {
    signs.wander = 0.49;
    CHECK(only_gate(signs) == "0 gates");
    signs.wander = 0.51;
    CHECK(only_gate(signs) == "wander");
  }
  SECTION("in- and expired volume") {
    signs.gain_mismatch = GENERATE(-0.019, 0.019);
    CHECK(screened(signs, adult_m3).tidal_volume_error == 0);
    signs.gain_mismatch *= 10;
    // If inspiration reads too high, the breath is too large by the part of expiration in time.
    CHECK(screened(signs, adult_m3).tidal_volume_error == Approx(0.19 * 0.6 / 1.96));
    CHECK_THAT(screened(signs, adult_m3).notes.at(0), Contains("differ by 19.0 %") && Contains("to 11.4 %"));
    CHECK(only_gate(signs) == "0 gates");
    signs.mismatch_by_duration = true;  // an offset of the flow, which is removed
    CHECK(screened(signs, adult_m3).tidal_volume_error == 0);
    signs.mismatch_by_duration = false;
    signs.gain_mismatch *= 2;
    CHECK(screened(signs, adult_m3).tidal_volume_error == 0);
    CHECK_THAT(screened(signs, adult_m3).notes.at(0), Contains("offset"));
    CHECK(only_gate(signs) == "0 gates");
    signs.mismatch_by_size = true;
    CHECK(only_gate(signs) == "gain_mismatch");
    signs.gain_mismatch *= 5;
    CHECK(only_gate(signs) == "not_a_breathing_signal");
  }
  SECTION("upside_down") {
    signs.orientation.upright = Upright::no;
    CHECK(only_gate(signs) == "upside_down");
    CHECK_THAT(screened(signs, adult_m3).gates.front().sentence, Contains("--invert"));
    signs.orientation.upright = Upright::unclear;
    CHECK(only_gate(signs) == "0 gates");
    CHECK_THAT(screened(signs, adult_m3).notes.at(0), Contains("which way is up"));
  }
  SECTION("doubts") {
    signs.breaths = 2, signs.inspiration_s = 0.05, signs.tidal_volume_m3 = 2100e-6;
    const Screening screening = screened(signs, adult_m3);
    REQUIRE(screening.notes.size() == 3);
    CHECK_THAT(screening.notes[0], StartsWith("2 breath(s) used"));
    CHECK_THAT(screening.notes[1], StartsWith("5.0 samples per inspiration"));
    CHECK_THAT(screening.notes[2], StartsWith("a tidal volume of 2100 ml is beyond"));
  }
}

namespace {

// Breaths that a muscle drives fire nothing; upside down they are seen or asked about.
void check_muscles(const std::vector<double>& recoils_s, const std::vector<double>& periods_s,
                   double rate_hz) {
  for (const auto& [name, activation] : test::muscle_shapes())
    for (const double recoil : recoils_s)
      for (const double period : periods_s) {
        CAPTURE(name, recoil, period, rate_hz);
        test::Breather who = breather(activation, recoil, period);
        who.rate_hz = rate_hz, who.noise_m3_s = 20e-6;
        const Trace trace = test::breathed(who, 7);
        // A half sine is its own mirror image, and a slow chest hides where it begins.
        const bool symmetric = name == "half sine";
        if (!symmetric || recoil < 0.5) CHECK(fired(trace) == std::set<std::string>{});
        CHECK_FALSE(fired(spirometer(trace, 4e-6)).contains("machine_driven"));
        if (symmetric) continue;
        const Segmentation turned = segment_breaths(upside_down(trace));
        CHECK(trace_signs(turned).orientation.upright != Upright::yes);
      }
}

// Breaths of ventilators are seen, upright and upside down.
void check_machines(const std::vector<double>& recoils_s, const std::vector<double>& periods_s) {
  for (const double recoil : recoils_s)
    for (const double period : periods_s) {
      for (const double rise : {0.0, 0.1, 0.2}) {
        CAPTURE(recoil, period, rise);
        test::Breather who = breather(test::pressure_control(rise), recoil, period);
        who.inspired_part = 0.33, who.size_cv = 0.03, who.timing_cv = 0.02;
        const Trace trace = test::breathed(who, 3);
        CHECK(fired(trace).contains("machine_driven"));
        if (rise < 0.2) CHECK(fired(spirometer(trace, 2e-6)).contains("machine_driven"));
        CHECK(fired(upside_down(trace)).contains("upside_down"));
        if (rise < 0.2) CHECK(fired(upside_down(trace)).contains("machine_driven"));
      }
      for (const double last : {1.0, 0.3})
        for (const double hold : {0.0, 0.08}) {
          CAPTURE(recoil, period, last, hold);
          test::ImposedFlow vent;
          vent.recoil_s = recoil, vent.period_s = period, vent.last = last, vent.hold_part = hold;
          CHECK(fired(test::imposed(vent, 3)).contains("machine_driven"));
          CHECK(fired(upside_down(test::imposed(vent, 3))).contains("upside_down"));
        }
    }
}

}  // namespace

TEST_CASE("Muscles pass, and machines are seen", "[unit][gates]") {
  check_muscles({0.3}, {1.75, 4.0}, 50);
  check_machines({0.6}, {4.0});
}

TEST_CASE("Muscles and machines of many kinds are told apart", "[nightly][gates]") {
  for (const double rate : {25.0, 100.0}) check_muscles({0.15, 0.3, 0.6, 1.2}, {1.75, 3.3, 6.0}, rate);
  check_machines({0.3, 0.6, 1.2}, {2.2, 4.0, 6.0});
}

TEST_CASE("A flowmeter that reads one way too high or too low leaves the tidal volume in its limits",
          "[unit][gates]") {
  test::Breather who = breather(test::muscle_shapes()[1].activation, 0.4, 4.0);
  who.inspired_part = GENERATE(0.28, 0.4);
  const Trace right = test::breathed(who, 5);
  const double truth = trace_signs(segment_breaths(right)).tidal_volume_m3;
  for (const bool inspiration : {true, false})
    for (const double gain : {0.85, 0.93, 1.07, 1.2}) {
      CAPTURE(who.inspired_part, inspiration, gain);
      Trace wrong = right;
      for (double& flow : wrong.value)
        if ((flow > 0) == inspiration) flow *= gain;
      const TraceSigns signs = trace_signs(segment_breaths(wrong));
      const double error = 1.96 * screened(signs, adult_m3).tidal_volume_error;
      CHECK(std::abs(signs.tidal_volume_m3 / truth - 1) < error + 0.01);
      CHECK(error < std::abs(gain - 1) + 0.01);  // no wider than the mismatch itself
    }
}

TEST_CASE("A large difference of in- and expired volume is told from an offset of the flow",
          "[unit][gates]") {
  test::Breather who = breather(test::muscle_shapes()[1].activation, 0.4, 4.0);
  who.timing_cv = 0.1;  // so that sizes and durations differ
  Trace doubled = test::breathed(who, 5), shifted = doubled;
  for (double& flow : doubled.value)
    if (flow > 0) flow *= 1.6;
  CHECK(fired(doubled) == std::set<std::string>{"gain_mismatch"});
  const double tidal_m3 = trace_signs(segment_breaths(shifted)).tidal_volume_m3;
  for (double& flow : shifted.value) flow += 0.5 * tidal_m3 / who.period_s;
  const Screening offset = screened(segment_breaths(shifted), adult_m3);
  CHECK(offset.gates.empty());
  CHECK(offset.tidal_volume_error == 0);
  CHECK_THAT(offset.notes.at(0), Contains("the flow has an offset"));
}

TEST_CASE("A wandering end-expiratory level is seen, and drift is not", "[unit][gates]") {
  Record record;
  record.breaths.resize(30);
  Trace trace = volume_trace(record);
  CHECK(fired(trace) == std::set<std::string>{});
  Trace drifting = trace, straying = trace;
  for (std::size_t i = 0; i < trace.value.size(); ++i) {
    drifting.value[i] += 40e-6 * trace.time_s[i];
    straying.value[i] += 450e-6 * std::sin(2 * std::numbers::pi * trace.time_s[i] / 40);
  }
  CHECK_FALSE(fired(drifting).contains("wander"));
  CHECK(fired(straying).contains("wander"));
}

TEST_CASE("Sizes are judged against the trunk", "[unit][gates]") {
  Record infant;
  infant.breaths.assign(20, {35e-6, 0.4, 0.5, 0.1});
  CHECK(fired(volume_trace(infant)) == std::set<std::string>{"subject_size"});
  CHECK(fired(volume_trace(infant), 100e-6) == std::set<std::string>{});
  CHECK(fired(volume_trace(infant), std::nullopt) == std::set<std::string>{});
}

TEST_CASE("What does not return is no breathing, even if the user says that it drifts", "[unit][gates]") {
  Record record;
  record.breaths.resize(14);
  Trace rectified = flow_trace(record, 0);
  for (double& flow : rectified.value) flow = std::abs(flow);
  CHECK_THROWS_AS(segment_breaths(rectified), InputError);
  rectified.drift_by_user = true;
  CHECK(fired(rectified).contains("not_a_breathing_signal"));
  CHECK_FALSE(fired(flow_trace(record, 0)).contains("not_a_breathing_signal"));
  const Trace plain = volume_trace(record);
  Trace counted = plain;
  for (std::size_t i = 1; i < counted.value.size(); ++i)
    counted.value[i] = counted.value[i - 1] + std::max(plain.value[i] - plain.value[i - 1], 0.0);
  CHECK_THROWS_AS(segment_breaths(counted), InputError);
  counted.drift_by_user = true;
  CHECK(fired(counted).contains("not_a_breathing_signal"));
}

namespace {

std::set<std::string> fired_by_file(const std::string& name, bool belt = false) {
  TraceOptions options;
  if (name.ends_with("inverted.csv"))
    options.time_unit = "s", options.unit = "L/s", options.time_column = "t";
  if (name.ends_with("inverted.csv")) options.value_column = "flow";
  return fired(read_trace(test::shared_file(name), options), belt ? std::nullopt : std::optional(adult_m3));
}

}  // namespace

TEST_CASE("Recordings fire the gates that they should", "[shared][gates]") {
  using Names = std::set<std::string>;
  CHECK(fired_by_file("cases/fits/square_ps.csv") == Names{"machine_driven"});
  CHECK(fired_by_file("cases/traces/vc_square.csv") == Names{"machine_driven"});
  CHECK(fired_by_file("cases/traces/inverted.csv") == Names{"upside_down"});
  CHECK(fired_by_file("cases/traces/infant35.csv") == Names{"subject_size"});
  for (const char* name : {"rectified.csv", "vcum.csv"})
    CHECK_THROWS_AS(fired_by_file("cases/traces/" + std::string(name)), InputError);
  for (const char* name :
       {"traces/cant_Subject01_0cmH2O_0mL.csv", "traces/cant_Subject03_0cmH2O_0mL.csv", "cases/fits/fast.csv",
        "cases/fits/rc_tau0.30.csv", "cases/fits/rc_tau0.60.csv", "cases/fits/rohrer.csv",
        "cases/traces/autozero.csv", "cases/traces/local_optimum.csv", "cases/traces/rest30_ex30.csv",
        "cases/traces/spike100.csv", "cases/traces/twin_v10_00.csv"}) {
    CAPTURE(name);
    CHECK(fired_by_file(name) == Names{});
  }
  CHECK(fired_by_file("traces/biosppy_resp_100Hz.csv", true) == Names{});
}

TEST_CASE("The recordings that the project has fire no gate", "[unit][gates]") {
  for (const char* name : {"constructed_trace.csv", "canterbury_subject03.csv"}) {
    CAPTURE(name);
    CHECK(fired(read_trace(std::filesystem::path(TRUNK_SOURCE_DIR) / "reference" / name)) ==
          std::set<std::string>{});
  }
}
