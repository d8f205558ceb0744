#pragma once

#include "traces/trace.hpp"

namespace trunk {

/// Check what was found in a trace against human breathing: period 0.8..30 s, tidal volume 30..6000 ml (our
/// choice, from a panting to a slow deep breath, from an infant's to a vital capacity). Throw InputError with
/// the trace's source that names the unit under which the number would make sense, if there is one.
void check_period(const Trace& trace, double median_period_s);
void check_tidal_volume(const Trace& trace, double median_tidal_volume_m3);

}  // namespace trunk
