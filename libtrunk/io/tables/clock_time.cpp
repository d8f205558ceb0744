#include "tables/clock_time.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <limits>
#include <string>

namespace trunk {
namespace {

constexpr double day_s = 86400, hour_s = 3600;

// Takes from one to `most` digits from the front.
std::optional<int> take_number(std::string_view& text, std::size_t most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + std::min(most, text.size()), value);
  if (error != std::errc{} || text.front() == '-') return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

// Takes a date and the 'T' or the spaces after it from the front. Returns the days since 1970. If there is no
// date, it returns nothing and leaves the text unchanged.
std::optional<double> take_date(std::string_view& text) {
  std::string_view rest = text;
  const auto first = take_number(rest, 4);
  if (!first || rest.empty()) return std::nullopt;
  const char mark = rest.front();
  if (mark != '-' && mark != '.' && mark != '/') return std::nullopt;
  rest.remove_prefix(1);
  const auto second = take_number(rest, 2);
  if (!second || !take(rest, mark)) return std::nullopt;
  const auto third = take_number(rest, 4);
  if (!third || rest.empty() || (rest.front() != ' ' && rest.front() != 'T')) return std::nullopt;
  rest.remove_prefix(1);
  while (take(rest, ' ')) continue;
  // The day comes first, unless the year does. If month and day may be swapped, the differences of times
  // within one day are still right.
  const bool year_first = *first > 31;
  const int year = year_first ? *first : *third, day = year_first ? *third : *first;
  using namespace std::chrono;
  year_month_day date(std::chrono::year(year), month(static_cast<unsigned>(*second)),
                      std::chrono::day(static_cast<unsigned>(day)));
  if (!date.ok() && !year_first)  // 03/31/2024
    date = year_month_day(std::chrono::year(year), month(static_cast<unsigned>(*first)),
                          std::chrono::day(static_cast<unsigned>(*second)));
  if (!date.ok()) return std::nullopt;
  text = rest;
  return static_cast<double>(sys_days(date).time_since_epoch().count());
}

// Returns whether a text may follow a time of day: "", "Z", "+02:00", "-0500".
bool is_zone(std::string_view text) {
  if (text.empty() || text == "Z") return true;
  return (text.front() == '+' || text.front() == '-') && text.size() <= 6 &&
         text.find_first_not_of("0123456789:", 1) == std::string_view::npos;
}

// Takes a fraction such as ".25" or ",25" from the front. Returns 0 if there is none, nothing if it is wrong.
std::optional<double> take_fraction(std::string_view& text) {
  if (text.empty() || (text.front() != '.' && text.front() != ',')) return 0.0;
  std::size_t length = 1;
  while (length < text.size() && text[length] >= '0' && text[length] <= '9') ++length;
  if (length == 1 || length > 18) return std::nullopt;
  const std::string digits = "0." + std::string(text.substr(1, length - 1));
  text.remove_prefix(length);
  double fraction = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), fraction);
  return fraction;
}

}  // namespace

std::optional<ClockTime> clock_time(std::string_view text) {
  if (text.size() > 40 || text.find(':') == std::string_view::npos) return std::nullopt;
  const auto days = take_date(text);
  std::array<int, 3> parts{};
  std::size_t count = 0;
  do {
    const auto part = count < parts.size() ? take_number(text, 3) : std::nullopt;
    if (!part || (count > 0 && *part > 59)) return std::nullopt;
    parts[count++] = *part;
  } while (take(text, ':'));
  const auto fraction = take_fraction(text);
  if (count < 2 || !fraction || !is_zone(text)) return std::nullopt;
  const int seconds = count == 3 ? 3600 * parts[0] + 60 * parts[1] + parts[2] : 60 * parts[0] + parts[1];
  return ClockTime{day_s * days.value_or(0) + seconds + *fraction, days ? 0 : count == 3 ? day_s : hour_s};
}

std::vector<double> seconds_since_first(const std::vector<std::optional<ClockTime>>& times) {
  std::vector<double> seconds(times.size(), std::numeric_limits<double>::quiet_NaN());
  std::optional<double> first, last;
  double passed = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!times[i]) continue;
    const double now = times[i]->seconds;
    if (!first) first = now;
    if (last && now - *last < -times[i]->period_s / 2) passed += times[i]->period_s;
    last = now;
    seconds[i] = now + passed - *first;
  }
  return seconds;
}

}  // namespace trunk
