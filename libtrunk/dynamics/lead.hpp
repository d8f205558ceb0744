#pragma once

#include <algorithm>

#include "dynamics/time_grid.hpp"
#include "model/parameters.hpp"
#include "model/state.hpp"

namespace trunk {

/// The longest lead that is simulated, s (our choice). It serves recoil times of up to 12 s.
inline constexpr double longest_lead_s = 120.0;

/// Returns how long before a breath breathing has to begin, so that nothing is left of its start: the memory
/// of the recoil (about 10 recoil times), or 10 times in which a swing fades, 2 m / c, if that is longer. The
/// volume is then within 1e-4 of that of breathing without end (our choice, and measured).
///
/// The memory is a number times c / k, and that number depends on the abdominal factor f. Stiffness only
/// grows with f, and less than in proportion. So the memory at f is at most max(1, f0 / f) times that at f0,
/// and this bound is used. A lung and an airway make it longer by about 11 times what they add to the recoil
/// time, and by what a pressure in the airway holds. It is infinite if nothing damps or nothing springs back.
/// Throws std::logic_error if the recoil of the model was not measured.
double lead_s(const Model& model, const Parameters<double>& parameters);

/// Returns the number of steps before t = 0 in which a trial begins at rest; 0 if the grid starts at rest.
/// Where something is displaced in the course of the breath, the lead consists of whole breaths, so that
/// nothing jumps when it begins.
int lead_steps(const Model& model, const Parameters<double>& parameters, const TimeGrid& grid);

/// Returns the time within a breath to which loads and imposed movements refer at a step; steps before 0
/// belong to earlier breaths.
double time_in_breath_s(const TimeGrid& grid, int step) noexcept;

/// The steps at which the lanes begin.
template <Scalar S>
struct Beginning {
  S step{0.0};       // not above 0
  int earliest = 0;  // of all lanes

  /// Returns where a lane has begun at a step.
  Mask<S> begun(int n) const noexcept { return Mask<S>(!(S(static_cast<double>(n)) < step)); }
};

/// Returns when each lane begins. Each has its own lead.
template <Scalar S>
Beginning<S> beginning_of(const Model& model, const Parameters<S>& parameters, const TimeGrid& grid) {
  Beginning<S> beginning;
  if (grid.start == Start::rest) return beginning;
  for (int i = 0; i < lanes_of<S>; ++i) {
    const int first = -lead_steps(model, in_lane(parameters, i), grid);
    set_lane(beginning.step, i, first);
    beginning.earliest = std::min(beginning.earliest, first);
  }
  return beginning;
}

}  // namespace trunk
