#pragma once

#include <vector>

#include "anatomy/measures.hpp"
#include "anatomy/scenario.hpp"
#include "dynamics/breath_course.hpp"

namespace trunk {

/// A simulated breath as a table knows it. Curves have one entry a step and one for the start.
struct BreathSummary {
  Ending ending;
  std::vector<double> delta_v;    // m3, lung volume above its start
  Measures measures;              // between the start and end-inspiration, where the lung volume was highest
  double peak_pressure_Pa = 0.0;  // abdominal, above rest
  double max_relative_volume_error = 0.0;
  int flipped_triangles = 0;  // of the lung at its largest or smallest: above 0 the model has left its range
};

/// All that is kept of one.
struct BreathRun : BreathSummary {
  std::vector<double> time_s;
  std::vector<double> activation;   // 0..1
  std::vector<double> pressure_Pa;  // abdominal, above rest
  double wall_s = 0.0;              // the time loop alone

  enum class Touch { none, slides, sticks };  // how a particle is on the surface that supports it
  struct Frame {
    int step;
    std::vector<Vec3d> position, velocity;  // [particles]
    std::vector<Touch> touch;               // [supports]
  };
  std::vector<Frame> frames;
  std::vector<Vec3d> end_inspiration;  // [particles] where the lung volume was highest
};

/// Simulates one breath and keeps curves, frames and measures. `frame_every` steps; 0 keeps no frames.
/// `check` may throw to end it.
BreathRun run_breath(const Trunk& trunk, const Scenario& scenario, int frame_every,
                     const WhileSimulated& check = {});

/// Curve and measures of many trials, several at a time in the lanes of a register. Each gives the bits it
/// would alone.
std::vector<BreathSummary> summarise_breaths(const Trunk& trunk, std::span<const Trial<double>> trials,
                                             const TimeGrid& grid, const WhileSimulated& check = {});

/// The lung volume alone: no frames, no measures.
VolumeCurve simulate_volume(const Trunk& trunk, const Parameters<double>& parameters,
                            const BreathActivation<double>& activation, const TimeGrid& grid);

/// How many trials this machine works off side by side.
std::size_t batch_lanes() noexcept;

/// The same for many trials, several at a time in the lanes of a register. Each gives the bits it would
/// alone.
std::vector<VolumeCurve> simulate_volumes(const Trunk& trunk, std::span<const Trial<double>> trials,
                                          const TimeGrid& grid);

/// The volume curve of a trial and how it changes along directions, exactly: each derivative has the entries
/// of the curve, m3 for a unit of its direction. A direction says by how much each number of the trial grows
/// (see no_change).
struct VolumeDerivatives {
  VolumeCurve curve;
  std::vector<std::vector<double>> along;  // [directions][steps + 1]
};
VolumeDerivatives simulate_volume_derivatives(const Trunk& trunk, const Trial<double>& trial,
                                              std::span<const Trial<double>> directions,
                                              const TimeGrid& grid);

}  // namespace trunk
