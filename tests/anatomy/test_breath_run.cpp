#include <cmath>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

double ml(double m3) {
  return 1e6 * m3;
}
double in_mm(double m) {
  return 1e3 * m;
}

}  // namespace

TEST_CASE("Paralysis of the left mirrors paralysis of the right within 2 %", "[regression][anatomy][slow]") {
  const Measures right = breath_of("hemiparalysis_right").measures,
                 left = breath_of("hemiparalysis_left").measures;
  const double scale = right.excursion_left;  // the healthy side's
  const double difference =
      std::max({std::abs(left.delta_v / right.delta_v - 1.0), std::abs(left.excursion_right / scale - 1.0),
                std::abs(left.excursion_left - right.excursion_right) / scale,
                std::abs(left.delta_l - right.delta_l) / right.delta_l});
  CAPTURE(difference);
  CHECK(right.delta_v > 100e-6);
  CHECK(difference < 0.02);
  WARN("left and right paralysis differ by " << 100 * difference << " %");
}

TEST_CASE("The paralysed dome rises while the healthy one descends, at about half the volume",
          "[regression][anatomy][slow]") {
  const BreathRun healthy = breath_of("healthy"), paralysed = breath_of("hemiparalysis_right");
  REQUIRE(healthy.ending.completed());
  REQUIRE(paralysed.ending.completed());
  const double ratio = paralysed.measures.delta_v / healthy.measures.delta_v;
  WARN("paralysed " << ml(paralysed.measures.delta_v) << " of " << ml(healthy.measures.delta_v)
                    << " ml, ratio " << ratio << ", paralysed dome "
                    << in_mm(paralysed.measures.excursion_right) << " mm, healthy "
                    << in_mm(paralysed.measures.excursion_left) << " mm (positive: descends)");
  CHECK(ratio > 0.40);
  CHECK(ratio < 0.60);
  CHECK(paralysed.measures.excursion_right < 0.0);
  CHECK(paralysed.measures.excursion_left > 5e-3);
  CHECK(healthy.measures.excursion_right > 5e-3);
  CHECK(healthy.measures.excursion_left > 5e-3);
}

TEST_CASE("Without ribs the paralysed dome does not rise", "[regression][anatomy][slow]") {
  // The published model has no paradox. Ours has it because of the ribs, not because of a script.
  CHECK(breath_of("published_hemiparalysis_right").measures.excursion_right > 0.0);
}

TEST_CASE("A trunk with both hemidiaphragms paralysed does not breathe", "[unit][anatomy]") {
  Scenario scenario = without_lung("healthy");
  scenario.tissue.paralysed = Side::both;
  scenario.parameters.muscle = 30.0;
  scenario.time.duration_s = 0.1;  // nothing happens, so a short time is enough
  const BreathRun run = run_breath(make_trunk(scenario), scenario, 0);
  CHECK(run.ending.completed());
  CHECK(std::abs(run.measures.delta_v) < 1e-12);
}

TEST_CASE("The curves of a breath have one entry for each step and end near their start",
          "[property][anatomy][slow]") {
  const Scenario scenario = without_lung("healthy");
  const BreathRun run = run_breath(make_trunk(scenario), scenario, 100);
  const auto steps = static_cast<std::size_t>(scenario.time.steps());
  CHECK(run.time_s.size() == steps + 1);
  CHECK(run.delta_v.size() == steps + 1);
  CHECK(run.activation.size() == steps + 1);
  CHECK(run.pressure_Pa.size() == steps + 1);
  CHECK(run.frames.size() == steps / 100 + 1);
  CHECK(run.delta_v.front() == 0.0);
  CHECK(run.time_s.back() == Approx(scenario.time.duration_s));
  CHECK(*std::max_element(run.delta_v.begin(), run.delta_v.end()) ==
        Approx(run.measures.delta_v).epsilon(1e-11));
  CHECK(run.max_relative_volume_error < 1e-13);
  // A breath: up, peak near the end of the rise, nearly back at the end.
  const auto peak = std::max_element(run.delta_v.begin(), run.delta_v.end()) - run.delta_v.begin();
  CHECK(run.time_s[static_cast<std::size_t>(peak)] == Approx(2.0).margin(0.1));
  CHECK(std::abs(run.delta_v.back()) < 0.05 * run.measures.delta_v);
}

TEST_CASE("The volume curve of a fit is that of the run", "[property][anatomy]") {
  Scenario scenario = without_lung("hemiparalysis_right");
  scenario.time.duration_s = 0.5;
  const Trunk trunk = make_trunk(scenario);
  const BreathRun run = run_breath(trunk, scenario, 0);
  const VolumeCurve curve = simulate_volume(trunk, scenario.parameters, scenario.activation, scenario.time);
  CHECK(curve.ending.completed());
  CHECK(curve.delta_v == run.delta_v);
}

TEST_CASE("Breaths side by side are the same as alone, also beside one that fails", "[property][anatomy]") {
  Scenario scenario = without_lung("hemiparalysis_right");
  scenario.time.duration_s = 0.3;
  const Trunk trunk = make_trunk(scenario);
  std::vector<Trial<double>> trials(batch_lanes() + 1, {scenario.parameters, scenario.activation});
  for (std::size_t i = 0; i < trials.size(); ++i)
    trials[i].parameters.muscle *= 1.0 + 0.2 * static_cast<double>(i);
  trials[1].parameters.elasticity = 1e7;  // unstable
  const auto together = summarise_breaths(trunk, trials, scenario.time);
  REQUIRE(together.size() == trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    scenario.parameters = trials[i].parameters;
    const BreathRun alone = run_breath(trunk, scenario, 0);
    CHECK(alone.ending.completed() == (i != 1));
    CHECK(together[i].ending.status == alone.ending.status);
    CHECK(together[i].ending.message == alone.ending.message);
    CHECK(together[i].delta_v == alone.delta_v);
    if (i == 1) continue;
    CHECK(together[i].measures.delta_l == alone.measures.delta_l);
    CHECK(together[i].measures.excursion_right == alone.measures.excursion_right);
    CHECK(together[i].peak_pressure_Pa == alone.peak_pressure_Pa);
    CHECK(together[i].peak_pressure_Pa ==
          *std::max_element(alone.pressure_Pa.begin(), alone.pressure_Pa.end()));
    CHECK(together[i].max_relative_volume_error == alone.max_relative_volume_error);
    CHECK(together[i].flipped_triangles == alone.flipped_triangles);
  }
  CHECK(together[0].measures.delta_l != together[2].measures.delta_l);
}

TEST_CASE("More muscle breathes more, more elasticity less", "[property][anatomy][slow]") {
  Scenario scenario = without_lung("healthy");
  scenario.time.duration_s = 2.0;
  const Trunk trunk = make_trunk(scenario);
  const auto volume = [&](double muscle, double elasticity) {
    Scenario s = scenario;
    s.parameters.muscle *= muscle;
    s.parameters.elasticity *= elasticity;
    return run_breath(trunk, s, 0).measures.delta_v;
  };
  const double usual = volume(1, 1);
  CHECK(volume(1.2, 1) > 1.1 * usual);
  CHECK(volume(1, 1.2) < 0.95 * usual);
  // Slow breathing depends on their ratio only.
  CHECK(volume(1.2, 1.2) == Approx(usual).epsilon(0.02));
}

TEST_CASE("A force on a region moves it, an unknown region is named", "[unit][anatomy]") {
  Scenario scenario = without_lung("healthy");
  scenario.parameters.muscle = 0.0;
  scenario.time.duration_s = 0.3;
  scenario.loads = {{RegionLoad::Kind::force,
                     "central_tendon",
                     {0, 0, -1},
                     {},
                     PiecewiseLinear({{0.0, 2.0}}),
                     {"here", 7}}};
  const Trunk trunk = make_trunk(scenario);
  CHECK(trunk.model.focal_forces.size() == 19);
  const BreathRun run = run_breath(trunk, scenario, 0);
  CHECK(run.ending.completed());
  CHECK(run.measures.delta_v > 10e-6);
  scenario.loads[0].region = "liver";
  CHECK_THROWS_WITH(make_trunk(scenario),
                    Contains("here:7") && Contains("'liver'") && Contains("abdominal_wall"));
}

TEST_CASE("A symmetric trunk moves symmetrically", "[property][anatomy][slow]") {
  const Scenario scenario = without_lung("healthy");
  const Trunk trunk = make_trunk(scenario);
  const BreathRun run = run_breath(trunk, scenario, 0);
  const auto& rest = trunk.model.rest;
  const Vec3d mirror(-1.0, 1.0, 1.0);
  double furthest = 0.0, largest_motion = 0.0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    std::size_t twin = 0;
    while (norm(rest[twin] - hadamard(mirror, rest[i])) > 1e-12) ++twin;
    const Vec3d motion = run.end_inspiration[i] - rest[i];
    furthest = std::max(furthest, norm(hadamard(mirror, motion) - (run.end_inspiration[twin] - rest[twin])));
    largest_motion = std::max(largest_motion, norm(motion));
  }
  WARN("mirror particles differ by up to " << 1e3 * furthest << " mm of " << 1e3 * largest_motion << " mm");
  CHECK(largest_motion > 5e-3);
  CHECK(furthest < 0.01 * largest_motion);
  CHECK(run.flipped_triangles == 0);
}
