#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "breaths/landmarks.hpp"
#include "breaths/selection.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// The part of a recording that the user chose, and the breaths in it.
struct TimeWindow {
  double begin_s = 0, end_s = 0;     ///< on the clock of the trace
  std::size_t first = 1, last = 1;   ///< numbers of the first and the last breath inside
  std::size_t breaths_recorded = 1;  ///< in the whole recording
};

/// Returns the window of --begin and --end, or nothing if neither is given. A breath is inside if all of it
/// is, to within a hundredth of a second, with which its times are shown. Throws InputError if the window
/// ends before it begins or holds no whole breath.
std::optional<TimeWindow> time_window(const BreathSelection& selection, const Landmarks& marks,
                                      const std::string& source);

/// Returns the breaths in a window alone, counting samples from `first_sample`.
WholeBreaths breaths_inside(const WholeBreaths& all, const TimeWindow& window, std::size_t first_sample);

/// Returns the samples of a window, first and last: from the peak of the breath before it to that of the
/// breath after it, so that the rests at both ends are seen from both sides.
std::pair<std::size_t, std::size_t> samples_inside(const WholeBreaths& all, const TimeWindow& window,
                                                   std::size_t samples);

/// Returns the sentence that says which breaths are used.
std::string note_of(const TimeWindow& window);

}  // namespace trunk
