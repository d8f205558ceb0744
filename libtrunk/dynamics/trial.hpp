#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "activation/breath_activation.hpp"
#include "math/dual.hpp"
#include "model/parameters.hpp"

namespace trunk {

/// Everything in which two simulations of one trunk over one time grid may differ.
template <Scalar S>
struct Trial {
  Parameters<S> parameters;
  BreathActivation<S> activation;
};

/// Returns the numbers of a trial, in a fixed order.
template <Scalar S>
std::array<S*, 12 + ShapeKnots::count> numbers(Trial<S>& trial) noexcept {
  auto& [p, a] = trial;
  std::array<S*, 12 + ShapeKnots::count> all = {&p.elasticity,     &p.muscle,         &p.damping,
                                                &p.abdomen_factor, &a.onset_s,        &a.rise_s,
                                                &a.fast_fall_s,    &a.slow_fall_s,    &a.fast_fall_level,
                                                &a.period_s,       &p.lung_elastance, &p.resistance};
  for (std::size_t k = 0; k < ShapeKnots::count; ++k) all[12 + k] = &a.shape[k];
  return all;
}

/// Returns one trial in each lane. trials: [1 to lanes_of<S>]; the last one also fills the other lanes.
template <Scalar S>
Trial<S> in_lanes(std::span<const Trial<double>> trials) noexcept {
  Trial<S> side_by_side;
  for (int i = 0; i < lanes_of<S>; ++i) {
    Trial<double> alone = trials[std::min(static_cast<std::size_t>(i), trials.size() - 1)];
    for (std::size_t n = 0; n < numbers(alone).size(); ++n)
      set_lane(*numbers(side_by_side)[n], i, *numbers(alone)[n]);
  }
  return side_by_side;
}

/// Returns the zero direction.
inline Trial<double> no_change() noexcept {
  Trial<double> direction;
  for (double* number : numbers(direction)) *number = 0.0;
  return direction;
}

/// Returns a trial with its derivatives along directions; the other tangents are 0. directions: [0 to N].
template <int N>
Trial<Dual<N>> with_tangents(const Trial<double>& trial, std::span<const Trial<double>> directions) noexcept {
  Trial<Dual<N>> result = in_lanes<Dual<N>>({&trial, 1});
  for (std::size_t i = 0; i < directions.size(); ++i) {
    Trial<double> direction = directions[i];
    for (std::size_t n = 0; n < numbers(direction).size(); ++n)
      set_lane(numbers(result)[n]->tangent, static_cast<int>(i), *numbers(direction)[n]);
  }
  return result;
}

}  // namespace trunk
