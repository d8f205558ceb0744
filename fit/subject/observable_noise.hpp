#pragma once

#include "estimation/estimate.hpp"

namespace trunk {

/// The unit in which a reader is shown what a channel measures, and how many of it one SI unit is.
struct ShownUnit {
  const char* name;
  double per_si;
};
ShownUnit shown_unit(ChannelKind kind);

/// The noise of an observable, as a fit found it.
struct ObservableNoise {
  std::string name, unit;          // "gastric pressure", "cmH2O"
  double noise = 0.0;              // deviation of a sample
  double autocorrelation = 0.0;    // of neighbouring samples
  double effective_samples = 0.0;  // n (1 - rho) / (1 + rho): how many independent ones tell as much
};

/// Returns the noise of the volume and of what was measured beside it; none without a linear model of the
/// fit.
std::vector<ObservableNoise> observable_noises(const MeasuredCurve& measured, const Estimation& estimation);

}  // namespace trunk
