#pragma once

#include <filesystem>

#include "breaths/mean_breath.hpp"
#include "traces/read_signal.hpp"

namespace trunk {

/// Returns the breaths of a trace and its channels.
///
/// Pleural pressure falls on inspiration, against airway pressure if that is recorded. So it shows which way
/// the signal goes up, if the equation of the lung explains more than half of its variance: if the shape of
/// the breaths leaves it open or says that the recording is upside down, and no volume and no --invert has
/// settled it, the signal is turned, and a note says so. Where shape or volume say that the signal is
/// upright, a pleural pressure that moves the wrong way is an error.
///
/// Throws InputError as segment_breaths, mean_channels and check_channels do.
Segmentation breaths_of(Trace trace, const BreathSelection& selection = {});

/// Returns the same of a file.
Segmentation read_breaths(const std::filesystem::path& path, const SignalOptions& options,
                          const BreathSelection& selection);

}  // namespace trunk
