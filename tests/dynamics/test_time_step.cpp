#include <cmath>

#include "dynamics/auto_time_step.hpp"
#include "dynamics/stability.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

struct Curves {
  std::vector<double> delta_v, pressure_Pa;  // at common times
};

/// A breath with another time step, kept every 16 ms.
Curves curves_with(Scenario scenario, double dt_s) {
  scenario.time.dt_s = dt_s;
  const BreathRun run = run_breath(make_trunk(scenario), scenario, 0);
  REQUIRE(run.ending.completed());
  const auto every = static_cast<std::size_t>(std::lround(0.016 / dt_s));
  Curves curves;
  for (std::size_t n = 0; n < run.delta_v.size(); n += every) {
    curves.delta_v.push_back(run.delta_v[n]);
    curves.pressure_Pa.push_back(run.pressure_Pa[n]);
  }
  return curves;
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

Ending run_at(const Model& model, const Parameters<double>& parameters, double dt_s, int steps,
              double* last_energy_over_first = nullptr) {
  // Full activation from the start shakes every mode.
  const BreathActivation<double> full{-2.0, 2.0, 1e9, 1.0, 1.0, 0.0};
  double first = 0.0;
  return simulate(model, parameters, full, {dt_s, steps * dt_s},
                  [&](int n, double, const State<double>& state, const StepReport<double>&) {
                    double speed2 = 0.0;
                    for (std::size_t i = 0; i < model.particles(); ++i) {
                      const Vec3d v = velocity(state, i, dt_s);
                      speed2 += dot(v, v);
                    }
                    if (n == 1) first = speed2;
                    if (last_energy_over_first) *last_energy_over_first = speed2 / first;
                  });
}

}  // namespace

TEST_CASE("Volume and pressure converge with the time step, with order about 1",
          "[property][dynamics][slow]") {
  for (const char* name : {"healthy", "published_healthy"}) {
    Scenario scenario = without_lung(name);
    scenario.time.duration_s = 3.2;  // past the peak and the fast fall
    const Curves c[] = {curves_with(scenario, 2e-3), curves_with(scenario, 1e-3), curves_with(scenario, 5e-4),
                        curves_with(scenario, 2.5e-4)};
    const auto orders = [&](auto member) {
      const double d0 = rms(c[0].*member, c[1].*member), d1 = rms(c[1].*member, c[2].*member),
                   d2 = rms(c[2].*member, c[3].*member);
      return std::pair{std::log2(d0 / d1), std::log2(d1 / d2)};
    };
    const auto volume = orders(&Curves::delta_v), pressure = orders(&Curves::pressure_Pa);
    const double largest_v = *std::max_element(c[3].delta_v.begin(), c[3].delta_v.end());
    const double error_at_1ms = 2.0 * rms(c[1].delta_v, c[2].delta_v) / largest_v;
    const double largest_p = *std::max_element(c[3].pressure_Pa.begin(), c[3].pressure_Pa.end());
    const double pressure_error_at_1ms = 2.0 * rms(c[1].pressure_Pa, c[2].pressure_Pa) / largest_p;
    INFO(name);
    CAPTURE(volume.first, volume.second, pressure.first, pressure.second);
    CHECK(volume.first == Approx(1.0).margin(0.4));  // contacts that begin and end make it uneven
    CHECK(volume.second == Approx(1.0).margin(0.25));
    CHECK(pressure.second > 0.7);
    CHECK(error_at_1ms < 1e-3);
    CHECK(pressure_error_at_1ms < 1e-2);
    WARN(name << ": observed order of volume " << volume.first << ", " << volume.second << "; of pressure "
              << pressure.first << ", " << pressure.second << "; RMS error at 1 ms over the peak, volume "
              << error_at_1ms << ", pressure " << pressure_error_at_1ms);
  }
}

TEST_CASE("A run completes just below the stability bound and fails above it", "[property][dynamics][slow]") {
  for (const char* name : {"healthy", "published_healthy", "hemiparalysis_right"})
    for (const double damping : {0.5, 20.0, 200.0}) {
      const Scenario scenario = without_lung(name);
      if (damping < 1.0 && scenario.reaction == Reaction::published)
        continue;  // it flutters at any time step
      Parameters<double> parameters = scenario.parameters;
      parameters.damping = damping;
      const Model model = make_trunk(scenario).model;
      const double bound = stable_time_step(model, parameters);
      double growth = 0.0;
      const Ending below = run_at(model, parameters, 0.9 * bound, 1500);
      const Ending above = run_at(model, parameters, 1.3 * bound, 1500, &growth);
      CAPTURE(name, damping, bound, growth, above.steps);
      INFO(below.message);
      CHECK(below.completed());
      CHECK((!above.completed() || growth > 100.0));
    }
}

TEST_CASE("The chosen time step is stable and its volume is within 0.1 % of that of 0.25 ms",
          "[property][dynamics][slow]") {
  struct Expected {
    const char* name;
    double at_least_s;
  };
  for (const Expected& expected : {Expected{"healthy", 5e-3},
                                   {"hemiparalysis_right", 5e-3},
                                   {"exercise_healthy", 4e-3},
                                   {"published_healthy", 5e-3}}) {
    const Scenario s = without_lung(expected.name);
    const Trunk trunk = make_trunk(s);
    const TimeStepChoice choice = auto_time_step(trunk.model, s.parameters, s.activation, s.time);
    CAPTURE(expected.name, choice.grid.dt_s, choice.stable_s, choice.estimated_error);
    CHECK(choice.grid.dt_s >= expected.at_least_s);
    CHECK(choice.grid.dt_s < choice.stable_s);
    const auto chosen = simulate_volume(trunk, s.parameters, s.activation, choice.grid).delta_v;
    const auto fine =
        simulate_volume(trunk, s.parameters, s.activation, {0.25e-3, s.time.duration_s}).delta_v;
    double apart = 0.0;
    for (std::size_t n = 0; n < chosen.size(); ++n) {
      const double place = static_cast<double>(n) * choice.grid.dt_s / 0.25e-3;
      const auto before = std::min(static_cast<std::size_t>(place), fine.size() - 2);
      const double there = std::lerp(fine[before], fine[before + 1], place - static_cast<double>(before));
      apart = std::max(apart, std::abs(chosen[n] - there));
    }
    const double error = apart / *std::max_element(fine.begin(), fine.end());
    CHECK(error < 1e-3);
    WARN(expected.name << ": " << 1e3 * choice.grid.dt_s << " ms, "
                       << (choice.grid.damping == Damping::centred ? "centred" : "implicit")
                       << " damping, error " << 100 * error << " %, estimated "
                       << 100 * choice.estimated_error << " %, stable below " << 1e3 * choice.stable_s
                       << " ms");
  }
}

TEST_CASE("Stiffer and finer models, and faster breaths, get shorter steps", "[property][dynamics][long]") {
  Scenario stiff = without_lung("healthy");
  stiff.parameters.elasticity *= 100.0;  // stable below 0.6 ms
  stiff.parameters.muscle *= 100.0;
  Scenario fine = without_lung("healthy");
  fine.geometry.resolution = 4;
  Scenario sudden = without_lung("healthy");
  sudden.parameters.damping = 2.0;
  sudden.activation.rise_s = 0.05;
  sudden.activation.fast_fall_s = 0.02;
  for (const Scenario& s : {stiff, fine, sudden}) {
    const double duration_s = 0.15;
    const Trunk trunk = make_trunk(s);
    const TimeStepChoice choice =
        auto_time_step(trunk.model, s.parameters, s.activation, {.duration_s = duration_s});
    const auto delta_v = [&](const TimeGrid& grid) {
      const VolumeCurve curve = simulate_volume(trunk, s.parameters, s.activation, grid);
      REQUIRE(curve.ending.completed());
      return curve.delta_v;
    };
    CAPTURE(choice.grid.dt_s, choice.stable_s, choice.estimated_error);
    CHECK(choice.grid.dt_s < choice.stable_s);
    const auto chosen = delta_v(choice.grid);
    const auto exact = delta_v({choice.grid.dt_s / 8.0, duration_s, Damping::centred});
    double apart = 0.0;
    for (std::size_t n = 0; n < chosen.size(); ++n)
      apart = std::max(apart, std::abs(chosen[n] - exact[8 * n]));
    const double error = apart / *std::max_element(exact.begin(), exact.end());
    CHECK(error < auto_time_step_tolerance);
    CHECK(error < 2.0 * choice.estimated_error);  // the estimate is not too small
  }
}

TEST_CASE("A model without stiffness gets a time step, although nothing bounds it", "[unit][dynamics]") {
  Scenario loose = without_lung("published_healthy");
  loose.parameters.elasticity = loose.parameters.muscle = 0.0;
  const Trunk trunk = make_trunk(loose);
  const TimeStepChoice choice =
      auto_time_step(trunk.model, loose.parameters, loose.activation, {.duration_s = 0.1});
  CHECK(std::isinf(choice.stable_s));
  CHECK(choice.grid.dt_s <= 8e-3);
}

TEST_CASE("The error is infinite if no step is good enough", "[unit][dynamics]") {
  const Scenario s = without_lung("healthy");
  const Model model = make_trunk(s).model;
  Parameters<double> repelled = s.parameters;
  repelled.elasticity *= -1.0;  // particles are pushed away from their rest shape
  CHECK(std::isinf(auto_time_step(model, repelled, s.activation, {.duration_s = 0.2}).estimated_error));
}

TEST_CASE("Without contact, centred damping leaves less than a tenth of the error",
          "[property][dynamics][slow]") {
  const auto error_at_4_ms = [](Damping damping) {
    Scenario scenario = without_lung("published_healthy");
    scenario.time.damping = damping;
    return rms(curves_with(scenario, 4e-3).delta_v, curves_with(scenario, 1e-3).delta_v);
  };
  const double implicit = error_at_4_ms(Damping::implicit), centred = error_at_4_ms(Damping::centred);
  CAPTURE(implicit, centred);
  CHECK(implicit > 1e-8);
  CHECK(centred < 0.1 * implicit);
}

TEST_CASE("The stability bound of one spring is that of the textbook", "[unit][dynamics]") {
  // Two equal masses joined by a fibre: w^2 = 2 k / m, dt < (g + sqrt(g^2 + 4 w^2)) / w^2 with g = c / m.
  Model model = free_body(tetrahedron(0.1), Reaction::variational, 0.5);
  model.fibres = {{0, 1, 1.0}};
  const double w2 = 2.0 * 300.0 / 0.5;
  CHECK(stable_time_step(model, {0.0, 300.0, 0.0}) == Approx(2.0 / std::sqrt(w2)).epsilon(1e-4));
  const double g = 8.0 / 0.5;
  CHECK(stable_time_step(model, {0.0, 300.0, 8.0}) ==
        Approx((g + std::sqrt(g * g + 4.0 * w2)) / w2).epsilon(1e-4));
  model.mass[0] = 1e9;  // a wall: w^2 = k / m
  model.damping_weight[0] = 2e9;
  CHECK(stable_time_step(model, {0.0, 300.0, 0.0}) == Approx(2.0 / std::sqrt(w2 / 2.0)).epsilon(1e-4));
}

TEST_CASE("Without stiffness every time step is stable", "[unit][dynamics]") {
  const Model model = free_body(octahedron(0.1), Reaction::variational, 0.2);
  CHECK(std::isinf(stable_time_step(model, {0.0, 0.0, 20.0})));
}

TEST_CASE("The stability bound scales as the square root of mass over stiffness", "[property][dynamics]") {
  Tissue light, heavy;
  heavy.particle_mass = 4.0 * light.particle_mass;
  const Model a = make_template_trunk({}, light, Reaction::variational).model;
  const Model b = make_template_trunk({}, heavy, Reaction::variational).model;
  const double bound = stable_time_step(a, {4000.0, 30.0, 0.0});
  CHECK(stable_time_step(b, {4000.0, 30.0, 0.0}) == Approx(2.0 * bound).epsilon(1e-3));
  CHECK(stable_time_step(a, {16000.0, 120.0, 0.0}) == Approx(0.5 * bound).epsilon(1e-3));
}
