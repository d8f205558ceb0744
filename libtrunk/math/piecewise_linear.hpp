#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "errors/input_error.hpp"

namespace trunk {

/// A value that changes over time: linear between events, held after the last, `before` ahead of the first.
/// With before = 0 it is the `valueEvent` list of a load in LML.
class PiecewiseLinear {
 public:
  struct Event {
    double time_s, value;
  };

  PiecewiseLinear() = default;

  /// Throws InputError unless the times increase strictly.
  explicit PiecewiseLinear(std::vector<Event> events, double before = 0.0)
      : events_(std::move(events)), before_(before) {
    for (std::size_t i = 1; i < events_.size(); ++i)
      if (!(events_[i - 1].time_s < events_[i].time_s))
        throw InputError("event times must increase: found " + std::to_string(events_[i].time_s) +
                         " s after " + std::to_string(events_[i - 1].time_s) + " s");
  }

  bool empty() const noexcept { return events_.empty(); }
  const std::vector<Event>& events() const noexcept { return events_; }

  double operator()(double time_s) const noexcept {
    if (events_.empty() || time_s < events_.front().time_s) return before_;
    if (time_s >= events_.back().time_s) return events_.back().value;
    const auto next = std::upper_bound(events_.begin(), events_.end(), time_s,
                                       [](double t, const Event& e) { return t < e.time_s; });
    const Event& a = *(next - 1);
    return a.value + (next->value - a.value) * (time_s - a.time_s) / (next->time_s - a.time_s);
  }

 private:
  std::vector<Event> events_;
  double before_ = 0.0;
};

}  // namespace trunk
