#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breaths/mean_breath.hpp"

namespace trunk {

/// What a user knows beside the trace.
struct ClinicOptions {
  std::optional<double> pdi_max_Pa;                   ///< of a maximal effort, for the tension-time index
  std::optional<double> chest_wall_compliance_m3_Pa;  ///< for work and pressure-time product; none: left out
};

/// A number that a respiratory laboratory reports, per breath and in the mean.
struct ClinicNumber {
  std::string name, unit;
  std::string meaning;                        ///< one line for a physiologist
  std::vector<double> each;                   ///< [MeasuredBreath::used] NaN where it cannot be known
  double mean = 0, lower95 = 0, upper95 = 0;  ///< over breaths; the interval of one breath is infinite
  double of_mean_breath = 0;  ///< the same number of the mean breath; NaN where it cannot be known
  std::string doubt{};        ///< why it is not to be trusted; or ""
};

/// Returns the numbers that the channels of a breath give, as far as they were measured; none without a
/// pressure. The definitions and their sources are in the table of clinic.cpp. The interval is that of
/// Student's t for the mean of breaths that vary independently. A lung resistance under 0.2 cmH2O s/L is less
/// than any airway has (our choice; healthy adults have 0.6 to 2.4): it, and the work of flow, are then
/// doubted.
std::vector<ClinicNumber> clinic_numbers(const MeasuredBreath& breath, const ClinicOptions& options);

}  // namespace trunk
