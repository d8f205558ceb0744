#include <cmath>
#include <cstring>

#include "support/allocations.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

/// The worst of what must hold at every step of a breath.
struct Watched {
  Ending ending;
  double volume_error = 0.0;      // relative to the target
  double penetration = -1.0;      // m, of the deepest support
  double depth_of_contact = 0.0;  // m, of supports that report contact
  int most_touching = 0;
};

Watched watch(const Scenario& scenario) {
  const Trunk trunk = make_trunk(scenario);
  const Model& model = trunk.model;
  Watched seen;
  seen.ending = simulate(
      model, scenario.parameters, scenario.activation, scenario.time,
      [&](int, double, const State<double>& state, const StepReport<double>&) {
        const double target = model.abdomen.target.empty() ? 1.0 : model.abdomen.target(state.time_s);
        const double volume = enclosed_volume<double>(model.abdomen.triangles, state.position);
        seen.volume_error =
            std::max(seen.volume_error, std::abs(volume / (target * model.abdomen.rest) - 1.0));
        int touching = 0;
        for (std::size_t s = 0; s < model.supports.size(); ++s) {
          const Support& support = model.supports[s];
          const double depth = outside(model, state, state.position, support);
          seen.penetration = std::max(seen.penetration, depth);
          touching += state.contact[s].touching;
          if (state.contact[s].touching)
            seen.depth_of_contact = std::max(seen.depth_of_contact, std::abs(depth));
        }
        seen.most_touching = std::max(seen.most_touching, touching);
      });
  return seen;
}

std::vector<double> bits_of_breath(const Scenario& scenario) {
  std::vector<double> numbers;
  simulate(make_trunk(scenario).model, scenario.parameters, scenario.activation, scenario.time,
           [&](int, double activation, const State<double>& state, const StepReport<double>& report) {
             numbers.push_back(activation);
             numbers.push_back(report.pressure_Pa);
             for (const Vec3d& p : state.position) numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
             for (const Vec3d& p : state.previous) numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
           });
  return numbers;
}

}  // namespace

TEST_CASE("The abdominal volume is held at every step of the published breath", "[property][dynamics]") {
  const Watched seen = watch(without_lung("published_healthy"));
  CHECK(seen.ending.completed());
  CHECK(seen.volume_error < 1e-13);
  WARN("published, no ribs: largest relative volume error " << seen.volume_error);
}

TEST_CASE("With ribs the volume is held and no support is crossed at any step",
          "[property][dynamics][slow]") {
  for (const char* name :
       {"healthy", "hemiparalysis_right", "exercise_healthy", "exercise_hemiparalysis_right"}) {
    const Watched seen = watch(shipped(name));
    INFO(name);
    CAPTURE(seen.volume_error, seen.penetration);
    CHECK(seen.ending.completed());
    CHECK(seen.volume_error < 1e-12);
    CHECK(seen.penetration < 1e-10);
    CHECK(seen.depth_of_contact < 1e-10);
    CHECK(seen.most_touching > 0);  // else the test shows nothing
    WARN(name << ": largest relative volume error " << seen.volume_error << ", deepest penetration "
              << seen.penetration << " m");
  }
}

TEST_CASE("An abdominal volume that changes in time is followed", "[property][dynamics][slow]") {
  for (const char* name : {"healthy", "published_healthy"}) {
    Scenario scenario = without_lung(name);
    scenario.abdominal_volume = PiecewiseLinear({{0.0, 1.0}, {1.0, 1.02}, {2.0, 0.98}}, 1.0);
    scenario.time.duration_s = 2.5;
    const Watched seen = watch(scenario);
    INFO(name);
    CAPTURE(seen.volume_error, seen.penetration);
    CHECK(seen.ending.completed());
    CHECK(seen.volume_error < 1e-12);
    CHECK(seen.penetration < 1e-10);
  }
}

TEST_CASE("A simulation repeated gives the same bits", "[property][dynamics]") {
  Scenario scenario = without_lung("hemiparalysis_right");
  scenario.time.duration_s = 0.5;
  const auto first = bits_of_breath(scenario), second = bits_of_breath(scenario);
  REQUIRE(first.size() > 100000);
  REQUIRE(first.size() == second.size());
  CHECK(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)) == 0);
}

TEST_CASE("A step allocates nothing", "[property][dynamics]") {
  const long at_start = allocations();
  int* volatile one = new int(0);  // volatile, since a compiler may leave out an allocation that nobody sees
  delete one;
  REQUIRE(allocations() > at_start);  // the counter counts

  for (const char* name : {"healthy", "published_healthy"}) {
    const Scenario scenario = laden(name);
    const Trunk trunk = make_trunk(scenario);
    State<double> state = rest_state<double>(trunk.model);
    Workspace<double> workspace = make_workspace(trunk.model, scenario.parameters, 1e-3);
    bool ok = true;
    const long before = allocations();
    for (int n = 0; n < 1500; ++n)
      ok = step(trunk.model, scenario.parameters, scenario.activation(state.time_s), state, workspace).ok &&
           ok;
    const long during = allocations() - before;
    INFO(name);
    CHECK(ok);
    CHECK(during == 0);
  }
}

TEST_CASE("At rest without activation nothing moves", "[property][dynamics][slow]") {
  // Every support touches without force: round-off decides which, and the search has to end all the same.
  for (const char* name : {"healthy", "published_healthy"}) {
    Scenario scenario = without_lung(name);
    scenario.parameters.muscle = 0.0;
    const Trunk trunk = make_trunk(scenario);
    const BreathRun run = run_breath(trunk, scenario, 0);
    INFO(name);
    CHECK(run.ending.completed());
    CHECK(largest(difference(run.end_inspiration, trunk.model.rest)) < 1e-12);
  }
}

TEST_CASE("A breath may begin after a pause", "[property][dynamics][slow]") {
  for (const char* name : {"healthy", "hemiparalysis_left", "published_healthy"})
    for (const double onset_s : {0.25, 1.0, 2.0}) {
      Scenario scenario = without_lung(name);
      scenario.activation.onset_s = onset_s;
      scenario.time.duration_s = onset_s + 0.5;
      const Watched seen = watch(scenario);
      CAPTURE(name, onset_s, seen.ending.message);
      CHECK(seen.ending.completed());
      CHECK(seen.volume_error < 1e-12);
    }
}

TEST_CASE("Several breaths with pauses complete", "[property][dynamics][slow]") {
  Scenario scenario = without_lung("healthy");
  scenario.activation = {0.0, 0.4, 0.1, 0.4, 0.4, 2.0};
  scenario.time.duration_s = 6.0;
  const Watched seen = watch(scenario);
  CAPTURE(seen.ending.message);
  CHECK(seen.ending.completed());
  CHECK(seen.volume_error < 1e-12);
  CHECK(seen.penetration < 1e-10);
}
