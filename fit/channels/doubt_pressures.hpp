#pragma once

#include <string>
#include <vector>

#include "breaths/mean_breath.hpp"

namespace trunk {

/// Returns the unit of a pressure with which gastric less pleural pressure would be the transdiaphragmatic
/// one, "if column 'Pga' is in kPa, ...", or "": with it they differ by less than a fifth of what they differ
/// by now, with their levels, and by less than 0.5 cmH2O (root of the mean square; our choice).
std::string other_unit_of_three(const MeasuredBreath& breath);

/// Returns what looks odd about the pressures of a mean breath and may still be right, a sentence each. The
/// limits are our choice:
///
/// * what other_unit_of_three finds;
/// * oesophageal, gastric or transdiaphragmatic pressure that swings by more than 60 cmH2O: a maximal effort;
/// * a pressure beyond 40 cmH2O at the end of expiration;
/// * transdiaphragmatic pressure that swings by less than 3 cmH2O for each litre, as over a paralysed
/// diaphragm;
/// * oesophageal pressure, where no airway pressure is measured, that swings by less than 3 or more than 100
///   cmH2O for each litre of a breath of 150 ml or more: a stiff and narrow lung takes 50, a wide one 5.
std::vector<std::string> doubt_pressures(const MeasuredBreath& breath);

}  // namespace trunk
