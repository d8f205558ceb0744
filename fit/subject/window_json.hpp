#pragma once

#include "breaths/time_window.hpp"
#include "subject/json.hpp"

namespace trunk {

/// Returns the window of a recording and the numbers of the breaths in it.
inline Json window_json(const TimeWindow& window) {
  return {{"begin_s", window.begin_s},
          {"end_s", window.end_s},
          {"first_breath", window.first},
          {"last_breath", window.last},
          {"breaths_recorded", window.breaths_recorded}};
}

}  // namespace trunk
