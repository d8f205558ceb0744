#include "dynamics/breath_chain.hpp"

#include <cmath>

#include "dynamics/recoil.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr double usual_period_s = 2.0, early_s = -0.15, margin_s = 0.3;

Scenario quick_breathing() {
  Scenario s = without_lung("healthy");
  s.parameters.elasticity = 1600.0;  // a recoil time of 0.3 s
  s.parameters.muscle = 11.0;
  s.activation = {.onset_s = early_s, .rise_s = 0.7, .fast_fall_s = 0.3, .slow_fall_s = 1.2};
  s.time = {2e-3, usual_period_s, Damping::centred, Start::periodic};
  return s;
}

/// A breath of a recording: when its volume starts, and how strong its muscle is.
struct Breath {
  double start_s, strength;
};

std::vector<Breath> uneven_breaths(int count) {
  Random random(23);
  std::vector<Breath> breaths{{0.0, 1.0}};
  while (static_cast<int>(breaths.size()) < count)
    breaths.push_back(
        {breaths.back().start_s + usual_period_s * random.between(0.9, 1.2), random.between(0.6, 1.4)});
  return breaths;
}

double end_of(const std::vector<Breath>& breaths, std::size_t i) {
  return i + 1 < breaths.size() ? breaths[i + 1].start_s : breaths[i].start_s + usual_period_s;
}

/// Returns tau V' + V = drive(t) from `first` on, at `count` times.
template <class Drive>
std::vector<double> one_compartment(double tau_s, double first, double first_s, double dt_s,
                                    std::size_t count, const Drive& drive) {
  std::vector<double> v{first};
  const double decay = std::exp(-dt_s / tau_s);
  while (v.size() < count)
    v.push_back(decay * v.back() +
                (1.0 - decay) * drive(first_s + (static_cast<double>(v.size()) - 0.5) * dt_s));
  return v;
}

}  // namespace

TEST_CASE("Equal breaths in a chain are the breath that repeats", "[property][dynamics]") {
  const Scenario s = quick_breathing();
  const Trunk trunk = make_trunk(s);
  const Trial<double> trial{s.parameters, s.activation};
  const VolumeCurve breath = simulate_volume(trunk, s.parameters, s.activation, s.time);
  BreathChain chain(trunk.model, s.time.dt_s, s.time.damping);
  REQUIRE(chain.begin_repeating(trial, usual_period_s, 10.0, 10.0 - margin_s).completed());
  CHECK(chain.now_s() == 10.0 - margin_s);
  for (int i = 0; i < 3; ++i) {
    const double start_s = 10.0 + i * usual_period_s;
    const auto curve =
        chain.attempt(trial, start_s, start_s + usual_period_s, start_s + usual_period_s - margin_s);
    REQUIRE(curve.ending.completed());
    const auto first = static_cast<std::size_t>(std::lround(margin_s / s.time.dt_s));
    REQUIRE(curve.volume.size() >= first + breath.delta_v.size());
    double apart = 0.0;
    const auto until_next = static_cast<std::size_t>((usual_period_s + early_s) / s.time.dt_s);
    for (std::size_t n = 0; n < until_next; ++n)
      apart =
          std::max(apart, std::abs(curve.volume[first + n] - breath.delta_v[n] - breath.above_relaxation));
    CHECK(apart < 1e-4 * *std::max_element(breath.delta_v.begin(), breath.delta_v.end()));
    chain.accept();
    CHECK(chain.now_s() == Approx(start_s + usual_period_s - margin_s).margin(s.time.dt_s));
  }
}

TEST_CASE("Uneven breaths in a chain are those of one compartment, each with the rest of those before",
          "[property][dynamics]") {
  const Scenario s = quick_breathing();
  const Trunk trunk = make_trunk(s);
  const Parameters<double>& p = s.parameters;
  const Recoil recoil = measure_recoil(trunk.model, p);
  const double tau_s = recoil.time_factor * p.damping / p.elasticity;
  const std::vector<Breath> breaths = uneven_breaths(8);
  const auto drive = [&](double time_s) {  // the last activation that has begun
    std::size_t i = breaths.size() - 1;
    while (i > 0 && time_s < breaths[i].start_s + early_s) --i;
    const double active = s.activation(time_s - breaths[i].start_s);
    return recoil.gain * breaths[i].strength * p.muscle / p.elasticity * active;
  };
  BreathChain chain(trunk.model, s.time.dt_s, s.time.damping);
  chain.begin_at_rest(-margin_s);
  const double dt_s = s.time.dt_s;
  const std::vector<double> expected = one_compartment(
      tau_s, 0.0, -margin_s, dt_s,
      static_cast<std::size_t>(std::lround((breaths.back().start_s + usual_period_s + margin_s) / dt_s)) + 10,
      drive);
  double squares = 0.0, largest = 0.0;
  std::size_t samples = 0, leftover = 0;
  for (std::size_t i = 0; i < breaths.size(); ++i) {
    Trial<double> trial{p, s.activation};
    trial.parameters.muscle *= breaths[i].strength;
    const double end_s = end_of(breaths, i);
    const auto curve = chain.attempt(trial, breaths[i].start_s, end_s, end_s - margin_s);
    REQUIRE(curve.ending.completed());
    const auto offset = static_cast<std::size_t>(std::lround((curve.first_s + margin_s) / dt_s));
    const auto kept = static_cast<std::size_t>((end_s - margin_s - curve.first_s) / dt_s);
    for (std::size_t n = 0; n < kept; ++n) {
      squares += std::pow(curve.volume[n] - expected[offset + n], 2);
      largest = std::max(largest, expected[offset + n]);
      ++samples;
    }
    if (curve.volume.front() > 20e-6) ++leftover;
    chain.accept();
  }
  CHECK(leftover > 4);  // otherwise each breath would start from rest by itself
  const double nrmse = std::sqrt(squares / static_cast<double>(samples)) / largest;
  CAPTURE(nrmse);
  CHECK(nrmse < 1e-2);
}

TEST_CASE("An attempt does not change the chain", "[property][dynamics]") {
  const Scenario s = quick_breathing();
  const Trunk trunk = make_trunk(s);
  Trial<double> weak{s.parameters, s.activation}, strong = weak, soft = weak;
  strong.parameters.muscle *= 1.5;
  soft.parameters.elasticity *= 0.8;
  BreathChain chain(trunk.model, s.time.dt_s, s.time.damping);
  chain.begin_at_rest(0.0);
  CHECK_THROWS_AS(chain.accept(), std::logic_error);
  const auto first = chain.attempt(weak, 0.2, 1.5, 1.0), other = chain.attempt(strong, 0.2, 1.5, 1.0),
             softer = chain.attempt(soft, 0.2, 1.5, 1.0), again = chain.attempt(weak, 0.2, 1.5, 1.0);
  CHECK(first.volume == again.volume);
  CHECK(other.volume.back() > 1.2 * first.volume.back());
  CHECK(softer.volume.back() > first.volume.back());
  chain.accept();
  // It goes on from the attempt that was accepted: the same volume at the same time.
  const auto next = chain.attempt(strong, 1.4, 3.0, 2.5);
  const auto kept = static_cast<std::size_t>(std::lround((next.first_s - first.first_s) / s.time.dt_s));
  CHECK(next.volume.front() == first.volume[kept]);
  CHECK(next.volume[50] == first.volume[kept + 50]);  // up to the next onset, the same breath goes on
  chain.accept();
  CHECK_THROWS_AS(chain.accept(), std::logic_error);
  CHECK_THROWS_AS(chain.attempt(weak, 3.0, 4.0, 2.0), std::logic_error);
  Trial<double> wild = weak;
  wild.parameters.elasticity = 1e8;
  CHECK_FALSE(chain.attempt(wild, 3.0, 4.0, 3.5).ending.completed());
  CHECK_THROWS_AS(chain.accept(), std::logic_error);
}

TEST_CASE("A chain refuses what belongs to single breaths", "[unit][dynamics]") {
  const Scenario swinging = without_lung("bucket_handle");
  CHECK_THROWS_WITH(BreathChain(make_trunk(swinging).model, 1e-3, Damping::implicit),
                    Contains("course of one breath"));
}
