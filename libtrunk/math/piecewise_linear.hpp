#pragma once

#include <algorithm>
#include <vector>

namespace trunk {

/// A value that changes over time: it is linear between events, keeps its value after the last one, and is
/// `before` ahead of the first. With before = 0 it is the `valueEvent` list of a load in LML.
class PiecewiseLinear {
 public:
  struct Event {
    double time_s, value;
  };

  PiecewiseLinear() = default;

  /// Throws InputError unless the times increase strictly.
  explicit PiecewiseLinear(std::vector<Event> events, double before = 0.0);

  bool empty() const noexcept { return events_.empty(); }
  const std::vector<Event>& events() const noexcept { return events_; }

  /// Returns the value at a time; `before` if there are no events.
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
