#include "breaths/time_window.hpp"

#include <fmt/format.h>

#include "breaths/breath_text.hpp"
#include "errors/input_error.hpp"

namespace trunk {
namespace {

constexpr double as_shown_s = 0.01;

// Returns a part of a list, both ends included.
template <class T>
std::vector<T> part(const std::vector<T>& all, std::size_t first, std::size_t last) {
  const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  return {at(first), at(last + 1)};
}

}  // namespace

std::optional<TimeWindow> time_window(const BreathSelection& selection, const Landmarks& marks,
                                      const std::string& source) {
  if (!selection.begin_s && !selection.end_s) return std::nullopt;
  const std::vector<double>& rest_s = marks.rest.time;
  const std::size_t count = marks.peak_s.size();
  TimeWindow window{selection.begin_s.value_or(rest_s.front()), selection.end_s.value_or(rest_s.back()), 0, 0,
                    count};
  if (selection.begin_s && selection.end_s && *selection.end_s <= *selection.begin_s)
    throw InputError({"--begin " + number_text(*selection.begin_s, 6)},
                     "--end " + number_text(*selection.end_s, 6) + " comes before it", "a later time in s");
  for (std::size_t i = 0; i < count; ++i) {
    if (rest_s[i] < window.begin_s - as_shown_s || rest_s[i + 1] > window.end_s + as_shown_s) continue;
    if (window.first == 0) window.first = i + 1;
    window.last = i + 1;
  }
  if (window.first == 0)
    throw InputError({source},
                     "no whole breath between --begin " + seconds_text(window.begin_s, 6) + " and --end " +
                         seconds_text(window.end_s, 6),
                     fmt::format("a part of the time from {} to {}, which holds {} breath(s)",
                                 seconds_text(rest_s.front(), 6), seconds_text(rest_s.back(), 6), count),
                     "list them with trunk breaths");
  return window;
}

WholeBreaths breaths_inside(const WholeBreaths& all, const TimeWindow& window, std::size_t first_sample) {
  WholeBreaths inside = all;
  inside.trough = part(all.trough, window.first - 1, window.last);
  inside.peak = part(all.peak, window.first - 1, window.last - 1);
  for (auto* samples : {&inside.trough, &inside.peak})
    for (std::size_t& i : *samples) i -= first_sample;
  return inside;
}

std::pair<std::size_t, std::size_t> samples_inside(const WholeBreaths& all, const TimeWindow& window,
                                                   std::size_t samples) {
  return {window.first > 1 ? all.peak[window.first - 2] : 0,
          window.last < all.peak.size() ? all.peak[window.last] : samples - 1};
}

std::string note_of(const TimeWindow& window) {
  return fmt::format("only the time from {} to {} is used: breaths {} to {} of {}",
                     seconds_text(window.begin_s, 6), seconds_text(window.end_s, 6), window.first,
                     window.last, window.breaths_recorded);
}

}  // namespace trunk
