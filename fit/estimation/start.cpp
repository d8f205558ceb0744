#include "estimation/start.hpp"

#include <algorithm>

#include "problem/free_parameters.hpp"

namespace trunk {

MeasuredCurve measured_curve_of(const MeasuredBreath& breath, bool weighted) {
  return {breath.time_s, breath.volume_m3, weighted ? breath.sigma_m3 : std::vector<double>()};
}

BreathActivation<double> activation_from_landmarks(const MeasuredBreath& breath) {
  const double expiration_s = breath.duration_s - breath.inspiration_s;
  BreathActivation<double> a;
  a.rise_s = breath.inspiration_s;
  a.fast_fall_s = 0.25 * expiration_s;
  a.slow_fall_s = 0.5 * expiration_s;
  for (const FreeParameter& p : free_parameters()) {  // a fit must start within its bounds
    if (p.group != FreeParameter::Group::timing) continue;
    Candidate c{{}, a};
    p.field(c) = std::clamp(p.field(c), p.lower, p.upper);
    a = c.activation;
  }
  return a;
}

}  // namespace trunk
