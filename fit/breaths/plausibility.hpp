#pragma once

#include <string>

#include "traces/trace.hpp"

namespace trunk {

/// Throw InputError if the breaths of a trace are not those of a human: period 0.8 to 30 s, from panting to
/// slow deep breathing; tidal volume 30 to 6000 ml, up to a vital capacity, and from 5 ml on in breaths
/// shorter than 2 s, as a newborn's (our choice: a slower small breath has a wrong unit). The remedy names
/// the unit with which the number would make sense, if there is one. If its unit changes on the way, it says
/// that instead (`change`, see doubts.hpp).
void check_period(const Trace& trace, double median_period_s);
void check_tidal_volume(const Trace& trace, double median_tidal_volume_m3, double median_period_s,
                        const std::string& change);

/// Throws InputError if the median breath has fewer than 6 samples: they do not show its top and its rest
/// (our choice).
void check_samples(const Trace& trace, double median_period_s);

}  // namespace trunk
