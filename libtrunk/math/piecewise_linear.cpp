#include "math/piecewise_linear.hpp"

#include <fmt/format.h>

#include "errors/input_error.hpp"

namespace trunk {

PiecewiseLinear::PiecewiseLinear(std::vector<Event> events, double before)
    : events_(std::move(events)), before_(before) {
  for (std::size_t i = 1; i < events_.size(); ++i)
    if (!(events_[i - 1].time_s < events_[i].time_s))
      throw InputError(
          {}, fmt::format("event at {} s found after one at {} s", events_[i].time_s, events_[i - 1].time_s),
          "times that increase");
}

}  // namespace trunk
