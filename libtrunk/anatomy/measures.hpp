#pragma once

#include <span>

#include "anatomy/trunk.hpp"

namespace trunk {

/// The shape of a trunk at one moment, m and m3.
struct Shape {
  double lung_volume = 0.0;
  double apposition_length = 0.0;  // mean over the muscle lines, costal insertion to top of the zone
  double dome_height = 0.0;        // mean of both domes above the mean top of the zone of apposition
  double half_width = 0.0;         // from side to side, mean over the free rings of the zone of apposition
  double right_dome = 0.0;         // mean height of the dome's top particles, in the axes of the trunk
  double left_dome = 0.0;
};

/// Returns the shape of a trunk. position: [particles] m.
Shape shape_of(const Trunk& trunk, std::span<const Vec3d> position);

/// A row of the paper's Table 1: one breath, from end-expiration to end-inspiration. m and m3.
struct Measures {
  double end_expiratory_volume = 0.0;
  double end_inspiratory_volume = 0.0;
  double delta_v = 0.0;
  double delta_l = 0.0;           // shortening of the zone of apposition
  double delta_l_fraction = 0.0;  // of its rest length
  double delta_h = 0.0;           // positive: the dome flattens (the sign is our choice)
  double delta_r = 0.0;           // positive: the zone of apposition widens
  double excursion_right = 0.0;   // positive: the dome descends, as in ultrasound
  double excursion_left = 0.0;
};

/// Returns the measures of a breath.
Measures measures_between(const Shape& end_expiration, const Shape& end_inspiration);

}  // namespace trunk
