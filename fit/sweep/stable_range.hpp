#pragma once

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <span>

#include "anatomy/scenario.hpp"
#include "errors/input_error.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {

/// Parameters and time steps for which a trunk is known to be stable, so that not every run needs a test. If
/// the reaction is the gradient of an energy, then a softer or more damped trunk, or a shorter time step, is
/// stable too. Several threads may call it.
class StableRange {
 public:
  /// Returns true if all scenarios are stable; false means that each must be tested alone.
  bool holds(const Trunk& trunk, std::span<const Scenario* const> scenarios) {
    constexpr double margin = 1.25;  // on the time step, for the error of power iteration
    if (scenarios.empty() || scenarios.front()->reaction != Reaction::variational) return false;
    const std::lock_guard lock(mutex_);
    Corner corner = known_.value_or(corner_of(*scenarios.front()));
    for (const Scenario* s : scenarios) corner = outermost(corner, corner_of(*s));
    if (corner == known_) return true;
    Scenario worst = *scenarios.front();
    worst.parameters = {corner[0], corner[1], -corner[3], corner[2], corner[5]};
    worst.time.dt_s = margin * corner[4];
    try {
      require_stable(worst, trunk);
    } catch (const InputError&) {
      return false;
    }
    known_ = corner;
    return true;
  }

 private:
  using Corner = std::array<double, 6>;  // a larger number is harder to keep stable

  static Corner corner_of(const Scenario& s) {
    const Parameters<double>& p = s.parameters;
    return {p.elasticity, p.muscle, p.abdomen_factor, -p.damping, s.time.dt_s, p.lung_elastance};
  }
  static Corner outermost(Corner a, const Corner& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::max(a[i], b[i]);
    return a;
  }

  std::mutex mutex_;
  std::optional<Corner> known_;
};

}  // namespace trunk
