#pragma once

#include <cmath>

#include "activation/breath_activation.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// How a breath begins.
///  - rest: everything is at rest at t = 0 (the paper's breaths).
///  - periodic: breathing has gone on for so long that each breath is like the one before (see lead_s).
enum class Start { rest, periodic };

/// The steps of a simulation.
struct TimeGrid {
  double dt_s = 1e-3;       // our choice; the paper ran about 3000 steps a second
  double duration_s = 4.5;  // one breath of the paper's activation
  Damping damping = Damping::implicit;
  Start start = Start::rest;

  int steps() const noexcept { return static_cast<int>(std::lround(duration_s / dt_s)); }
  bool operator==(const TimeGrid&) const = default;

  /// Returns the activation at a time.
  template <Scalar S>
  S active(const BreathActivation<S>& activation, double time_s) const noexcept {
    return start == Start::periodic ? activation.repeated(time_s, duration_s) : activation(time_s);
  }
};

}  // namespace trunk
