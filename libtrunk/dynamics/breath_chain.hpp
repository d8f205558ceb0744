#pragma once

#include <vector>

#include "dynamics/volume_curve.hpp"

namespace trunk {

/// The breaths of a recording one after the other: each starts with what the one before has left. Times are
/// those of the recording. The activation of a breath begins at its own onset, and cuts the tail of the one
/// before.
///
/// A breath is tried as often as needed before it is accepted:
///
///     chain.begin_repeating(usual, 3.3, 12.0, 11.7);     // breathing as in the mean breath, up to 11.7 s
///     for (each breath) {
///       curve = chain.attempt(trial, start_s, end_s, next_onset_s);   // again with another trial, or
///       chain.accept();                                               // go on from next_onset_s
///     }
///
/// An attempt costs its steps, 2.4 us each for 113 particles: 1.0 to 1.5 ms for a breath of 3.3 s. Accepting
/// costs nothing.
class BreathChain {
 public:
  /// The model must outlive the chain. Throws InputError if loads, the abdominal volume or rigid parts of the
  /// model follow courses, since their times are those of a single breath.
  BreathChain(const Model& model, double dt_s, Damping damping);

  /// Starts at rest at that time.
  void begin_at_rest(double at_s);

  /// Starts in breathing that has repeated for long: one breath of the trial, whose volume starts at
  /// `start_s`, every `period_s`. The chain goes on from `at_s`. Throws as lead_s does. Returns how the
  /// simulation ended; the chain has not begun if it did not complete.
  Ending begin_repeating(const Trial<double>& trial, double period_s, double start_s, double at_s);

  /// The lung volume above relaxation, so that one baseline serves a whole recording.
  struct Curve {
    Ending ending;
    double first_s = 0.0, dt_s = 0.0;  // the time of the first sample, and between two
    std::vector<double> volume;        // m3; as far as the simulation came
  };

  /// Simulates the next breath from the kept state, which stays. Times of the activation count from
  /// `start_s`; its onset must not be before the kept state. The curve begins with the kept state and ends
  /// at `end_s` or less than a step later. `keep_s` is the moment from which the chain goes on if the breath
  /// is accepted: not after the earliest onset that the next breath may have. What follows `keep_s` is as if
  /// no breath came after this one. Throws std::logic_error if `keep_s` is before the onset of this breath.
  Curve attempt(const Trial<double>& trial, double start_s, double end_s, double keep_s);

  /// Goes on from the moment that the last attempt was to keep. Throws std::logic_error if that attempt did
  /// not get so far.
  void accept();

  /// Returns the time of the kept state.
  double now_s() const noexcept { return kept_.time_s; }

 private:
  /// A moment, and the breath whose activation lasts until the next one begins.
  struct Moment {
    State<double> state;
    double time_s = 0.0;
    BreathActivation<double> activation;
    double muscle = 0.0;   // N/m; 0: no breath yet
    double start_s = 0.0;  // to which the times of the activation refer
  };

  void prepare(const Parameters<double>& parameters);

  const Model& model_;
  double rest_volume_;  // m3, of the lung
  double dt_s_;
  Damping damping_;
  Moment kept_, next_;
  bool next_reached_ = false;
  Parameters<double> prepared_for_;
  Workspace<double> workspace_;
};

}  // namespace trunk
