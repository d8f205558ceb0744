#include <cmath>

#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

struct Outcome {
  Ending ending;
  bool saw_only_finite_numbers = true;
  int observed = 0;
};

Outcome outcome_of(const Scenario& scenario) {
  Outcome outcome;
  outcome.ending =
      simulate(make_trunk(scenario).model, scenario.parameters, scenario.activation, scenario.time,
               [&](int, double, const State<double>& state, const StepReport<double>& report) {
                 ++outcome.observed;
                 bool good = std::isfinite(report.pressure_Pa);
                 for (const Vec3d& p : state.position) good = good && finite(dot(p, p));
                 outcome.saw_only_finite_numbers = outcome.saw_only_finite_numbers && good;
               });
  return outcome;
}

}  // namespace

TEST_CASE("A run that blows up is reported, and no NaN is observed before", "[property][dynamics]") {
  struct Absurd {
    const char* what;
    void (*make)(Scenario&);
  };
  const Absurd cases[] = {
      {"a time step of 20 ms", [](Scenario& s) { s.time.dt_s = 20e-3; }},
      {"a time step of 1 s",
       [](Scenario& s) {
         s.time.dt_s = 1.0;
         s.time.duration_s = 600.0;
       }},
      {"an elasticity of 10^6 N/m", [](Scenario& s) { s.parameters.elasticity = 1e6; }},
      {"an elasticity of 10^12 N/m", [](Scenario& s) { s.parameters.elasticity = 1e12; }},
      {"an elasticity of 10^300 N/m", [](Scenario& s) { s.parameters.elasticity = 1e300; }},
      {"a muscle of 10^6 N/m", [](Scenario& s) { s.parameters.muscle = 1e6; }},
      {"NaN for the muscle", [](Scenario& s) { s.parameters.muscle = std::nan(""); }},
  };
  for (const char* name : {"healthy", "published_healthy"})
    for (const Absurd& absurd : cases) {
      Scenario scenario = without_lung(name);
      absurd.make(scenario);
      const Outcome outcome = outcome_of(scenario);
      INFO(name << ", " << absurd.what << ": " << outcome.ending.message);
      CHECK((outcome.ending.status == Ending::Status::diverged ||
             outcome.ending.status == Ending::Status::volume_lost));
      CHECK(outcome.saw_only_finite_numbers);
      CHECK(outcome.observed <= outcome.ending.steps);  // step 0 counts, and the broken step is not observed
      CHECK(outcome.ending.message.find(" s") != std::string::npos);
    }
}

TEST_CASE("An ending that was never set is no success", "[unit][dynamics]") {
  CHECK_FALSE(Ending{}.completed());
  CHECK(Ending{}.status == Ending::Status::unset);
}

TEST_CASE("A particle that leaves the trunk ends the run as diverged", "[unit][dynamics]") {
  Scenario scenario = without_lung("healthy");
  scenario.parameters.damping = 0.0;
  const Trunk trunk = make_trunk(scenario);
  Model model = trunk.model;
  // A lung particle is set free and pushed. It belongs to no held volume, so only its distance can show this.
  const int lung = trunk.mesh.named("lung_top").front();
  model.mobility[static_cast<std::size_t>(lung)] = {1, 1, 1};
  model.focal_forces = {{lung, {0, 0, 1}, PiecewiseLinear({{0.0, 100.0}})}};
  int last_seen = 0;
  const Ending ending = simulate(model, scenario.parameters, scenario.activation, {1e-3, 1.0},
                                 [&](int n, double, const auto&, const auto&) { last_seen = n; });
  CHECK(ending.status == Ending::Status::diverged);
  CHECK(last_seen == ending.steps - 1);
  CHECK(ending.time_s < 0.1);  // 1/2 500 m/s2 t^2 leaves a trunk of under 1 m
}
