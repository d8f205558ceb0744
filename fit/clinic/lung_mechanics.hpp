#pragma once

#include "clinic/breath_loop.hpp"

namespace trunk {

/// What a breath says about the lung, if the pressure across it is a + E V + R V'.
struct LungMechanics {
  double elastance = 0;   ///< E, Pa/m3
  double resistance = 0;  ///< R, Pa s/m3
  double explained = 0;   ///< share of the pressure's variance that the equation explains
  double rise_Pa = 0;     ///< E VT + R VT/Ti: about how far the pressure rises on inspiration
};

/// Returns elastance and resistance by least squares over all samples of a breath (Wald et al., Comput Biomed
/// Res 1969;2:411). The loop has a pleural pressure.
LungMechanics lung_mechanics(const BreathLoop& loop);

/// Returns how far a pressure changes before inspiratory flow begins, Pa: from the corner of two straight
/// lines, which is where the effort begins, to the onset of the next breath. The lines are fitted by least
/// squares to the last second before the onset, at most half the expiration. It is 0 unless the corner lowers
/// the residual variance to less than half of that of one straight line, and unless the second line goes the
/// way of `sign`, that of an effort, up to its end: in its last half by half as steeply or more (our choice).
/// What expiratory muscles add before they let go cannot be told from it.
double change_before_flow(const BreathLoop& loop, const std::vector<double>& pressure, double sign);

}  // namespace trunk
