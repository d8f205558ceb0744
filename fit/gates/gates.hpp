#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breaths/segment.hpp"
#include "gates/trace_signs.hpp"

namespace trunk {

/// Why a recording must not be fitted as it is: muscle against recoil, the recoil time constant and stiffness
/// in N/m are withheld.
struct Gate {
  std::string name;      ///< for files: upside_down, machine_driven, gain_mismatch, subject_size, wander,
                         ///< not_a_breathing_signal
  std::string sentence;  ///< what is wrong and what to do
};

/// What stands against a fit, before anything is simulated.
struct Screening {
  std::vector<Gate> gates;
  std::vector<std::string> notes;  ///< what is accepted and the user should know
  /// Relative standard error of the tidal volume by a gain that differs with the direction of flow; it goes
  /// into all volumes, added to other errors as the root of the sum of squares.
  double tidal_volume_error = 0;
};

/// Returns what stands against fitting a recording. `end_expiratory_m3` is the volume of the lungs of the
/// trunk at rest; without it, as for a belt without calibration, size is not judged. The limits:
///
/// * upside_down: see upside_down.hpp. If it is unclear, a note asks.
/// * machine_driven: inspiratory flow grows from 10 to 90 % within 0.10 s; or within 0.17 s, while expiratory
///   flow does so within 0.095 s. For breaths shorter than 2 s these times are shorter in proportion.
/// * subject_size: a tidal volume outside 2 to 80 % of the end-expiratory volume.
/// * wander: the end-expiratory level varies by more than half a tidal volume.
/// * not_a_breathing_signal: in- and expired volume differ by more than 1.5 of their mean, as of a flow that
///   has lost its sign and of a volume that counts up.
///
/// * gain_mismatch: they differ by a share d from 0.3 on, and the difference grows with the size of a breath
///   and not with its duration, as when a flowmeter reads one direction too high.
///
/// For 0.02 < |d| < 0.3 either volume may be the true one, and each breath is in between after its drift is
/// removed: the share of inspiration in time, or of expiration, of d away. The larger of the two is taken as
/// a 95 % limit of the tidal volume's relative error; a note says so. If d grows with the duration of a
/// breath, it is an offset of the flow, which is removed breath by breath and does no harm. The limits are
/// our choice: they separate the recordings and the constructed breaths of tests/fit/gates.
Screening screened(const TraceSigns& signs, std::optional<double> end_expiratory_m3);
Screening screened(const Segmentation& segmentation, std::optional<double> end_expiratory_m3);

/// Returns the gate of a tidal volume that a trunk cannot have, for a fit to one number too.
std::optional<Gate> subject_size(double tidal_volume_m3, double end_expiratory_m3);

}  // namespace trunk
