// One compartment, whose exact solution is compared with small steps of Euler's method.

#include "compartment/compartment_breath.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace trunk;

namespace {

/// A(t) of endless breathing: each onset cuts the breath before.
double repeated(const BreathActivation<double>& a, double time_s, double period_s) {
  const double phase = time_s - a.onset_s;
  return a(a.onset_s + phase - period_s * std::floor(phase / period_s));
}

/// Follows the compartment over many breaths, until nothing is left of the start, and returns the volumes of
/// the last one.
std::vector<double> by_steps(const Compartment& c, const BreathActivation<double>& a, const TimeGrid& grid,
                             int samples, int breaths) {
  const int steps = 200;  // between two samples
  const double dt = grid.duration_s / (samples * steps);
  std::vector<double> volumes;
  double volume = 0.0;
  for (int breath = 0; breath < breaths; ++breath) {
    volumes = {volume};
    for (int i = 0; i < samples * steps; ++i) {
      const double t = (i + 0.5) * dt + (breath - breaths + 1) * grid.duration_s;
      const double active = grid.start == Start::periodic ? repeated(a, t, grid.duration_s) : a(t);
      const double decay = std::exp(-dt / c.time_constant_s);
      volume = decay * volume + (1.0 - decay) * c.gain_m3 * active;
      if ((i + 1) % steps == 0) volumes.push_back(volume);
    }
  }
  return volumes;
}

BreathActivation<double> bent(double onset_s) {
  BreathActivation<double> a{.onset_s = onset_s, .rise_s = 0.9, .fast_fall_s = 0.3, .slow_fall_s = 1.1};
  a.shape = {0.5, 0.8, 1.1, 1.2, 1.05, 0.7, 1.3, 0.6, 0.4};
  return a;
}

void compare(const Compartment& c, const BreathActivation<double>& a, const TimeGrid& grid, int breaths) {
  const int samples = 150;
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(grid.duration_s * i / samples);
  const std::vector<double> truth = by_steps(c, a, grid, samples, breaths);
  const CompartmentBreath found = compartment_breath(c, a, grid, times);
  CHECK(found.above_relaxation_m3 == Approx(truth.front()).margin(1e-8));
  for (std::size_t i = 0; i < times.size(); ++i) {
    CAPTURE(i, times[i]);
    CHECK(found.delta_v[i] == Approx(truth[i] - truth.front()).margin(3e-8));  // of 500 ml
  }
}

}  // namespace

TEST_CASE("A compartment breathes as small steps say, from rest and without end", "[unit][fit]") {
  for (const double onset_s : {-0.2, 0.0, 0.15})
    for (const double tau_s : {0.2, 0.9}) {
      CAPTURE(onset_s, tau_s);
      const Compartment c{tau_s, 600e-6};
      TimeGrid grid{1e-3, 2.6};
      compare(c, bent(onset_s), grid, 1);
      grid.start = Start::periodic;
      compare(c, bent(onset_s), grid, 20);
      grid.duration_s = 1.7;  // the next breath cuts the slow fall
      compare(c, bent(onset_s), grid, 20);
    }
}

TEST_CASE("The volume of a compartment follows from its mean activation", "[unit][fit]") {
  // tau dV/dt + V = gain A, over a breath that repeats: the mean of V is gain times the mean of A.
  const Compartment c{0.7, 500e-6};
  TimeGrid grid{1e-3, 2.6};
  grid.start = Start::periodic;
  const BreathActivation<double> a = bent(-0.1);
  std::vector<double> times;
  const int samples = 20000;
  for (int i = 0; i < samples; ++i) times.push_back(grid.duration_s * (i + 0.5) / samples);
  const CompartmentBreath breath = compartment_breath(c, a, grid, times);
  double volume = 0.0, activation = 0.0;
  for (const double v : breath.delta_v) volume += (v + breath.above_relaxation_m3) / samples;
  for (const double t : times) activation += repeated(a, t, grid.duration_s) / samples;
  CHECK(volume == Approx(c.gain_m3 * activation).epsilon(1e-5));
}

TEST_CASE("A compartment that follows a sine lags by the angle of calculus", "[unit][fit]") {
  // tau V' + V = a sin(w t): V = a cos(p) sin(w t - p), with tan p = w tau. Straight lines between 2000
  // samples are the sine to 2e-6 of a.
  const double tau_s = 0.5, size = 400e-6;
  TimeGrid grid{1e-3, 3.0};
  grid.start = Start::periodic;
  const double w = 2.0 * M_PI / grid.duration_s, lag = std::atan(w * tau_s);
  std::vector<double> times, held;
  for (int i = 0; i <= 2000; ++i) {
    times.push_back(grid.duration_s * i / 2000);
    held.push_back(size * std::sin(w * times.back()));
  }
  const CompartmentBreath breath = driven_breath(tau_s, held, grid, times);
  for (std::size_t i = 0; i < times.size(); i += 50) {
    CAPTURE(times[i]);
    CHECK(breath.delta_v[i] + breath.above_relaxation_m3 ==
          Approx(size * std::cos(lag) * std::sin(w * times[i] - lag)).margin(1e-5 * size));
  }
}
