#pragma once

#include <span>
#include <string>
#include <vector>

#include "anatomy/trunk.hpp"

namespace trunk {

/// What the stored frames of a run do not say themselves: measures of Table 1 as they grow, and where the
/// diaphragm lies against the ribs. T frames, S supports, F fibres.
struct Motion {
  std::vector<double> delta_l_mm, delta_h_mm, delta_r_mm, excursion_right_mm, excursion_left_mm;  // [T]
  std::vector<std::int32_t> support_particle;                                                     // [S]
  std::vector<std::uint8_t> touching;  // [T*S] 1: within 1 um of the rigid surface (our choice)
  std::vector<double> fibre_activity;  // [F] 1 healthy, 0 paralysed
};

/// Measures each frame as the simulator does, from rest. frames: [T][particles] m at `time_s` [T].
Motion motion_of(const Trunk& trunk, std::span<const double> time_s,
                 std::span<const std::vector<Vec3d>> frames);

}  // namespace trunk
