#pragma once

#include <string>

#include "breaths/mean_breath.hpp"
#include "errors/input_error.hpp"

namespace trunk {

/// Throws InputErrors, which name the column and the remedy, if the channels of a mean breath cannot be what
/// they are called. The limits are our choice:
///
/// * a pressure whose mean breath swings by more than 150 cmH2O, or by less than 0.05 (but airway pressure,
///   which may rest); an excursion of more than 150 mm or less than 1 mm; an EMG that does not change;
/// * gastric pressure that is the same as pleural pressure: within 2 % of its swing (root of the mean
/// square);
/// * transdiaphragmatic pressure that is not gastric less pleural pressure: by more than 0.5 cmH2O and 10 %
/// of
///   its swing (root of the mean square over the mean breath);
/// * transdiaphragmatic pressure that falls on inspiration: its mean over inspiration is below that over
///   expiration by more than a quarter of its swing.
void check_channels(const MeasuredBreath& breath, const std::string& source);

/// Returns notes on channels that move as they do in health only if their sign is reversed: a gastric
/// pressure or an excursion whose correlation with the volume is below -0.5.
std::vector<std::string> doubts_about(const MeasuredBreath& breath);

/// Which way the pressure across the lung goes with the volume.
struct PressureSign {
  bool rises = true;     ///< on inspiration, as it must
  bool clear = false;    ///< the equation of the lung explains more than half of its variance
  double explained = 0;  ///< share of its variance
  double rise_Pa = 0;    ///< see LungMechanics
};

/// Returns which way airway less pleural pressure goes in the mean breath, which has a pleural pressure.
PressureSign pressure_sign(const MeasuredBreath& breath);

/// Returns an error about a pleural pressure that moves the wrong way.
InputError wrong_way(const MeasuredBreath& breath, const PressureSign& sign, const std::string& source);

}  // namespace trunk
