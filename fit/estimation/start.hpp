#pragma once

#include "breaths/mean_breath.hpp"
#include "problem/measured_curve.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// Returns the curve of a measured breath, with what was measured beside its volume. A transdiaphragmatic
/// pressure says nothing new beside the two pressures of which it is the difference, and is left out. With
/// `weighted`, each sample of the volume has the deviation that the breath gives. Each channel counts as 20
/// independent samples at first, with a deviation of 5 % of its largest change (our choice; the noise that is
/// found replaces it). One excursion has an error of 2 mm (our choice: a ninth of the right dome's 18 mm in
/// quiet breathing of men, Boussuges et al., Chest 2009;135:391).
MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted = false);

/// Returns each breath, [breaths][values], as the curve has its mean. Where a channel leaves a breath out,
/// the mean stands in for it; what differs in the others is larger by that.
std::vector<std::vector<double>> breaths_of(const MeasuredBreath& breath, const MeasuredCurve& measured);

/// Returns a first guess of the activation: straight lines that rise over the inspiration and fall over the
/// expiration (our choice). The volume lags behind the muscle, so it is only where searches begin.
BreathActivation<double> activation_from_landmarks(const MeasuredBreath& breath);

}  // namespace trunk
