#pragma once

#include "dynamics/simulate.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

/// How far a volume curve may be from the one of very short steps, over its largest value.
inline constexpr double auto_time_step_tolerance = 1e-3;

/// A time grid and what it was chosen for.
struct TimeStepChoice {
  TimeGrid grid;
  double stable_s = 0.0;         // the spectral bound on its step, or infinity
  double estimated_error = 0.0;  // of the volume curve, over its largest value
};

/// The longest step of 0.95, 0.95 x 0.85, 0.95 x 0.85^2 ... of the spectral bound, at most 8 ms and such that
/// the breath is whole steps, that shows the volume of short steps within the tolerance, with the damping
/// that does (our choice; runs of the shipped scenarios are stable up to the bound itself). Short steps r are
/// of 1 ms, less where the bound is below 4 ms; with V_r their curve, the error at h is taken to be |V_h -
/// V_r| h / (h - r): true of an error that is proportional to the step, too much of one that grows faster.
/// Costs about three breaths at 1 ms. Where no step longer than 1.5 r serves, r is halved, up to three times;
/// then the shortest is the choice, its error that of steps twice as long. Infinite where no simulation
/// completes. The bound is that of a model `stiffer` times as stiff.
TimeStepChoice auto_time_step(const Model& model, const Parameters<double>& parameters,
                              const BreathActivation<double>& activation, double duration_s,
                              double stiffer = 1.0);

/// For searches and draws, which go to stiffer parameters than those they begin with (our choice).
inline constexpr double stiffer_in_searches = 2.0;

/// The error of a grid as auto_time_step estimates it: to see whether a step chosen for some parameters
/// serves others. Infinite where a simulation fails.
double time_step_error(const Model& model, const Parameters<double>& parameters,
                       const BreathActivation<double>& activation, const TimeGrid& grid);

}  // namespace trunk
