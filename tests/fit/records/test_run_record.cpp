#include <cmath>

#include "errors/input_error.hpp"
#include "records/run_record.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;

namespace {

/// The beginning of a healthy breath in long steps, simulated once for all tests, with frames every 40 ms.
struct ShortRun {
  ScenarioFile file = read_scenario(test::scenario_folder() / "healthy_no_lung.toml");
  Trunk trunk;
  BreathRun run;

  ShortRun() {
    file.scenario.time.dt_s = 4e-3;
    file.scenario.time.duration_s = 0.4;
    trunk = make_trunk(file.scenario);
    run = run_breath(trunk, file.scenario, 10);
  }
};

const ShortRun& short_run() {
  static const ShortRun one;
  return one;
}

const Series& series_named(const std::vector<Series>& all, const std::string& name) {
  for (const Series& s : all)
    if (s.name == name) return s;
  FAIL("there is no series " << name);
  return all.front();
}

}  // namespace

TEST_CASE("A breath that did not complete has the same measures, all unknown", "[records]") {
  BreathSummary half = short_run().run;
  half.swings.emplace();
  const auto whole = measures_of(half);
  half.ending.status = Ending::Status::diverged;
  const auto unknown = measures_of(half);
  REQUIRE(unknown.size() == whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CHECK(unknown[i].name == whole[i].name);
    CHECK(unknown[i].unit == whole[i].unit);
    CHECK(std::isfinite(whole[i].value));
    CHECK(std::isnan(unknown[i].value));
  }
}

TEST_CASE("Parameters go into a record and back into a scenario", "[records]") {
  Scenario slow = test::shipped("healthy"), other = test::shipped("published_healthy");
  slow.parameters.elasticity = 1234.5;
  slow.activation.slow_fall_s = 7.0;
  const auto parameters = parameters_of({slow.parameters, slow.activation});
  adopt_parameters(parameters, other);
  for (const FreeParameter& p : free_parameters()) {
    INFO(p.name);
    CHECK(value_of(p, {other.parameters, other.activation}) ==
          value_of(p, {slow.parameters, slow.activation}));
  }
  CHECK(other.time.duration_s >= 7.0 + slow.activation.rise_s);  // the simulation covers the slow breath
  CHECK_THROWS_WITH(adopt_parameters({{"strength", "1", 1.0}}, other),
                    Contains("there is no parameter 'strength'"));
}

TEST_CASE("The curves of a record are those of the run, and the residual is model minus measured",
          "[records]") {
  const auto& [file, trunk, run] = short_run();
  const MeasuredCurve measured{{0.0, 0.2, 0.4}, {0.0, 50e-6, 100e-6}, {}};
  const RunRecord record = run_record(file, trunk, run, measured, {});
  CHECK(record.status == "completed");
  REQUIRE(record.curve_time_s.size() == run.time_s.size());
  const auto &model = series_named(record.curves, "dV_model").values,
             &observed = series_named(record.curves, "dV_measured").values,
             &residual = series_named(record.curves, "residual").values;
  for (std::size_t i = 0; i < model.size(); ++i) {
    CHECK(model[i] == Approx(1e6 * run.delta_v[i]));
    CHECK(observed[i] == Approx(250.0 * run.time_s[i]).margin(1e-9));  // ml, a straight line
    CHECK(residual[i] == Approx(model[i] - observed[i]).margin(1e-9));
  }
  CHECK(run_record(file, trunk, run, {}, {}).curves.size() == 3);  // nothing was measured
}

TEST_CASE("Frames of a record are the frames of the run, with the lengths of Table 1", "[records]") {
  const auto& [file, trunk, run] = short_run();
  const RunRecord record = run_record(file, trunk, run, {}, {});
  const Trajectory& t = record.trajectory;
  REQUIRE(t.time_s.size() == run.frames.size());
  REQUIRE(t.particles == trunk.model.particles());
  CHECK(t.time_s.back() == Approx(0.4));
  CHECK(t.position_m.size() == 3 * t.particles * run.frames.size());
  CHECK(t.position_m[3 * t.particles + 1] == run.frames[1].position[0].y());
  for (const Series& s : record.frame_series) CHECK(s.values.size() == run.frames.size());
  CHECK(series_named(record.frame_series, "dL").values.front() == Approx(0.0).margin(1e-9));
  CHECK(series_named(record.frame_series, "dL").values.back() > 0.0);
  CHECK(series_named(record.frame_series, "dV").values.back() == Approx(1e6 * run.delta_v.back()));
}

TEST_CASE("Without frames a record keeps a sample of its curves every 10 ms", "[records]") {
  const auto& [file, trunk, run] = short_run();
  BreathRun bare = run;
  bare.frames.clear();
  ScenarioFile fine = file;
  fine.scenario.time.dt_s = 2.5e-3;  // four steps are 10 ms
  const RunRecord record = run_record(fine, trunk, bare, {}, {});
  CHECK(record.trajectory.particles == 0);
  CHECK(record.curve_time_s.size() == (run.time_s.size() + 3) / 4);
  CHECK(record.curve_time_s[1] == run.time_s[4]);
}

TEST_CASE("The scenario in a record can be run again, and holds the user's text", "[records]") {
  const auto& [file, trunk, run] = short_run();
  const std::string text = scenario_text(file);
  CHECK_THAT(text, Contains("# as given in ") && Contains("# schema = \"trunk.scenario/1\""));
  const ScenarioFile again = scenario_of_text(text, "again", "");
  CHECK(to_toml(again.scenario) == to_toml(file.scenario));
}
