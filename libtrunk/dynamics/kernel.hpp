#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dynamics/step.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

struct TimeGrid;
struct VolumeCurve;
struct BreathCurves;
struct BreathCourse;

/// A function that a simulation calls every few steps. An exception from it ends the simulation and is passed
/// on.
using WhileSimulated = std::function<void()>;

/// The simulator's loops, compiled for one instruction set. All kernels give the same bits.
struct Kernel {
  const char* instruction_set;
  int lanes;     // trials side by side in `volume_curves`
  int tangents;  // directions at once in `volume_derivatives`
  Step<double>* step;

  /// Calculates the curves of 1 to `lanes` trials.
  void (*volume_curves)(const Model&, std::span<const Trial<double>>, const TimeGrid&,
                        std::span<VolumeCurve>);
  /// Calculates the curve of one trial.
  void (*volume_curve)(const Model&, std::span<const Trial<double>>, const TimeGrid&, std::span<VolumeCurve>);
  /// Calculate the courses of 1 to `lanes` trials, and of one trial.
  void (*breath_courses)(const Model&, std::span<const Trial<double>>, const TimeGrid&, const WhileSimulated&,
                         std::span<BreathCourse>);
  void (*breath_course)(const Model&, std::span<const Trial<double>>, const TimeGrid&, const WhileSimulated&,
                        std::span<BreathCourse>);
  /// Calculates the curves of one trial, and the derivatives of what is observed, above rest, along 1 to
  /// `tangents` directions, per unit of the direction.
  void (*volume_derivatives)(const Model&, const Trial<double>&, std::span<const Trial<double>> directions,
                             const TimeGrid&, VolumeCurve&, std::span<BreathCurves> derivatives);
};

/// Returns the kernels that this machine can run, the fastest one last.
std::span<const Kernel* const> kernels();

/// Returns the fastest kernel of this machine.
const Kernel& kernel();

}  // namespace trunk
