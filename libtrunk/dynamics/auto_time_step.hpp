#pragma once

#include "dynamics/simulate.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

/// The largest allowed distance of a volume curve from that of very short steps, over its largest value.
inline constexpr double auto_time_step_tolerance = 1e-3;

/// A time grid, and the figures by which it was chosen.
struct TimeStepChoice {
  TimeGrid grid;
  double stable_s = 0.0;         // the spectral bound on its step; infinity if there is none
  double estimated_error = 0.0;  // of the volume curve, over its largest value
};

/// Returns the longest step, with its damping, for a breath with the duration and the start of `breath`,
/// whose volume curve is within the tolerance of that of short steps (all our choice). Candidates are 0.95,
/// 0.95 x 0.85, 0.95 x 0.85^2 ... of the spectral bound, at most 8 ms, and made shorter until the breath is a
/// whole number of steps. Runs of the shipped scenarios are stable up to the bound. The bound is that of a
/// model `stiffer` times as stiff.
///
/// Short steps r take 1 ms, or a quarter of the bound if that is less. With V_r their curve, the error of a
/// step h is estimated as |V_h - V_r| h / (h - r). This is right if the error is proportional to the step,
/// and too large if it grows faster. If no step longer than 1.5 r is within the tolerance, r is halved, up to
/// three times. After that the choice is the shortest r, and its error is that of steps twice as long. The
/// error is infinite if no simulation completes. The search costs about three breaths at 1 ms.
TimeStepChoice auto_time_step(const Model& model, const Parameters<double>& parameters,
                              const BreathActivation<double>& activation, const TimeGrid& breath,
                              double stiffer = 1.0);

/// `stiffer` for searches and draws, which reach stiffer parameters than those at their start (our choice).
inline constexpr double stiffer_in_searches = 2.0;

/// Returns the error of a grid as auto_time_step estimates it; infinity if a simulation fails. It shows
/// whether a step that was chosen for some parameters is short enough for others.
double time_step_error(const Model& model, const Parameters<double>& parameters,
                       const BreathActivation<double>& activation, const TimeGrid& grid);

}  // namespace trunk
