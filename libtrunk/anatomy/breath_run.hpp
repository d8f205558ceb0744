#pragma once

#include <vector>

#include "anatomy/measures.hpp"
#include "anatomy/scenario.hpp"
#include "dynamics/breath_course.hpp"

namespace trunk {

/// What a table keeps of a simulated breath. Curves have one entry for each step and one for the start.
struct BreathSummary {
  Ending ending;
  std::vector<double> delta_v;          // m3, lung volume above its value at t = 0
  double above_relaxation = 0.0;        // m3, of the lung volume at t = 0 (end-expiration); 0 from rest
  Measures measures;                    // from t = 0 to end-inspiration, where the lung volume is highest
  double peak_pressure_Pa = 0.0;        // abdominal, above rest
  double gastric_swing_Pa = 0.0;        // of the same, see PleuralSwings
  std::optional<PleuralSwings> swings;  // with a lung
  double right_rise = 0.0, left_rise = 0.0;  // m, of the domes above t = 0 at the most
  double max_relative_volume_error = 0.0;
  int flipped_triangles = 0;  // of the lung; above 0: the model is out of its range
};

/// Everything that is kept of a simulated breath.
struct BreathRun : BreathSummary {
  std::vector<double> time_s;
  std::vector<double> activation;           // 0..1
  std::vector<double> pressure_Pa;          // abdominal, above rest
  std::vector<double> pleural_pressure_Pa;  // above rest; empty without a lung
  double wall_s = 0.0;                      // duration of the time loop

  enum class Touch { none, slides, sticks };  // contact of a particle with the surface that supports it
  struct Frame {
    int step;
    std::vector<Vec3d> position, velocity;  // [particles]
    std::vector<Touch> touch;               // [supports]
  };
  std::vector<Frame> frames;
  std::vector<Vec3d> start;            // [particles] m, at t = 0
  std::vector<Vec3d> end_inspiration;  // [particles] m, where the lung volume is highest
};

/// Simulates one breath and returns its curves, frames and measures. A frame is kept every `frame_every`
/// steps; 0 keeps none. `check` may throw to end the simulation.
BreathRun run_breath(const Trunk& trunk, const Scenario& scenario, int frame_every,
                     const WhileSimulated& check = {});

/// Returns the curves and measures of many trials. Several are simulated at a time, in the lanes of a
/// register; each has the bits that it has alone.
std::vector<BreathSummary> summarise_breaths(const Trunk& trunk, std::span<const Trial<double>> trials,
                                             const TimeGrid& grid, const WhileSimulated& check = {});

/// Returns the curves of one trial, without frames and measures.
VolumeCurve simulate_volume(const Trunk& trunk, const Parameters<double>& parameters,
                            const BreathActivation<double>& activation, const TimeGrid& grid);

/// Returns the lung volume at the start of a scenario's own breath, m3: that at rest, and what breaths before
/// have left where breathing repeats. Throws InputError if it cannot repeat.
double end_expiratory_volume(const Trunk& trunk, const Scenario& scenario);

/// Returns the number of trials that this machine simulates side by side.
std::size_t batch_lanes() noexcept;

/// Returns the curves of many trials. Several are simulated at a time, in the lanes of a register; each
/// has the bits that it has alone.
std::vector<VolumeCurve> simulate_volumes(const Trunk& trunk, std::span<const Trial<double>> trials,
                                          const TimeGrid& grid);

/// The curves of a trial and their exact derivatives along directions. A direction says by how much each
/// number of the trial grows (see no_change).
struct VolumeDerivatives {
  VolumeCurve curve;
  std::vector<BreathCurves> along;       // [directions] per unit of the direction
  std::vector<double> above_relaxation;  // [directions] the same of the volume at t = 0
};
/// Returns the curves and their derivatives.
VolumeDerivatives simulate_volume_derivatives(const Trunk& trunk, const Trial<double>& trial,
                                              std::span<const Trial<double>> directions,
                                              const TimeGrid& grid);

}  // namespace trunk
