#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dynamics/step.hpp"
#include "dynamics/trial.hpp"

namespace trunk {

struct TimeGrid;
struct VolumeCurve;
struct BreathCourse;

/// Called every few steps of a simulation; what it throws ends the simulation and is passed on.
using WhileSimulated = std::function<void()>;

/// The simulator's loops as compiled for one instruction set. All of them give the same bits.
struct Kernel {
  const char* instruction_set;
  int lanes;     // trials side by side in `volume_curves`
  int tangents;  // directions at once in `volume_derivatives`
  Step<double>* step;

  /// The curves of 1 to `lanes` trials.
  void (*volume_curves)(const Model&, std::span<const Trial<double>>, const TimeGrid&,
                        std::span<VolumeCurve>);
  /// The curve of one.
  void (*volume_curve)(const Model&, std::span<const Trial<double>>, const TimeGrid&, std::span<VolumeCurve>);
  /// The courses of 1 to `lanes` trials, and of one.
  void (*breath_courses)(const Model&, std::span<const Trial<double>>, const TimeGrid&, const WhileSimulated&,
                         std::span<BreathCourse>);
  void (*breath_course)(const Model&, std::span<const Trial<double>>, const TimeGrid&, const WhileSimulated&,
                        std::span<BreathCourse>);
  /// The curve of one with its derivatives along 1 to `tangents` directions, m3 a unit of the direction.
  void (*volume_derivatives)(const Model&, const Trial<double>&, std::span<const Trial<double>> directions,
                             const TimeGrid&, VolumeCurve&, std::span<std::vector<double>> derivatives);
};

/// Those that this machine can run, the best one last.
std::span<const Kernel* const> kernels();

/// The best one.
const Kernel& kernel();

}  // namespace trunk
