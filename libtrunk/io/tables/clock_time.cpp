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

bool is_ascii_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

char lower(char c) {
  return static_cast<char>(c | 0x20);  // of a letter
}

// Takes a word from the front if it stands there in any case.
bool take_word(std::string_view& text, std::string_view word) {
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (!is_ascii_letter(text[i]) || lower(text[i]) != word[i]) return false;
  text.remove_prefix(word.size());
  return true;
}

// Takes spaces, also those that do not break (U+00A0, U+202F).
void take_spaces(std::string_view& text) {
  for (bool found = true; found;) {
    found = take(text, ' ');
    for (const std::string_view space : {std::string_view("\xC2\xA0"), std::string_view("\xE2\x80\xAF")})
      if (text.starts_with(space)) text.remove_prefix(space.size()), found = true;
  }
}

// Takes the second number of a date: "03", or "Mar" in English.
std::optional<int> take_month_or_day(std::string_view& text) {
  constexpr std::array<std::string_view, 12> months{"jan", "feb", "mar", "apr", "may", "jun",
                                                    "jul", "aug", "sep", "oct", "nov", "dec"};
  for (std::size_t i = 0; i < months.size(); ++i)
    if (take_word(text, months[i])) return static_cast<int>(i + 1);
  return take_number(text, 2);
}

// Takes "1 days " from the front. If it is not there, it returns nothing and leaves the text unchanged.
std::optional<double> take_days(std::string_view& text) {
  std::string_view rest = text;
  const auto days = take_number(rest, 6);
  take_spaces(rest);
  if (!days || !take_word(rest, "day")) return std::nullopt;
  take_word(rest, "s");
  take(rest, ',');
  take_spaces(rest);
  text = rest;
  return *days;
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
  const auto second = take_month_or_day(rest);
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

// Takes "AM", "pm" or "p. m." from the front. Returns 'a', 'p', or ' ' if there is none.
char take_half_day(std::string_view& text) {
  std::string_view rest = text;
  take_spaces(rest);
  if (rest.empty() || !is_ascii_letter(rest.front())) return ' ';
  const char half = lower(rest.front());
  rest.remove_prefix(1);
  take(rest, '.');
  take_spaces(rest);
  if ((half != 'a' && half != 'p') || !take_word(rest, "m")) return ' ';
  take(rest, '.');
  text = rest;
  return half;
}

// Takes the same before a time, in Chinese, Japanese or Korean.
char take_half_day_in_front(std::string_view& text) {
  for (const std::string_view word : {"上午", "午前", "오전", "下午", "午後", "오후"}) {
    if (!text.starts_with(word)) continue;
    text.remove_prefix(word.size());
    take_spaces(text);
    return word == "上午" || word == "午前" || word == "오전" ? 'a' : 'p';
  }
  return ' ';
}

// Returns the offset from UTC in seconds that a text after a time of day names: "", "Z", "+02:00", "-0500",
// "+02", " UTC+2"; 0 for the name of a zone; nothing for any other text.
std::optional<double> zone_s(std::string_view text) {
  take_spaces(text);
  if (text.empty() || text == "Z" || text == "z") return 0;
  std::size_t letters = 0;
  while (letters < text.size() && text[letters] >= 'A' && text[letters] <= 'Z') ++letters;
  if (letters == text.size()) return letters >= 3 && letters <= 5 ? std::optional(0.0) : std::nullopt;
  if (letters > 0 && !take_word(text, "utc") && !take_word(text, "gmt")) return std::nullopt;
  const double sign = text.front() == '-' ? -1 : 1;
  if (!take(text, '+') && !take(text, '-')) return std::nullopt;
  const auto hours = take_number(text, 2);
  const bool colon = take(text, ':');
  const auto minutes = text.empty() && !colon ? std::optional(0) : take_number(text, 2);
  if (!hours || !minutes || !text.empty() || *hours > 14 || *minutes > 59) return std::nullopt;
  return sign * (hour_s * *hours + 60 * *minutes);
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
  if (text.size() > 60 || text.find(':') == std::string_view::npos) return std::nullopt;
  auto days = take_date(text);
  if (!days) days = take_days(text);
  char half_day = take_half_day_in_front(text);
  std::array<int, 3> parts{};
  std::size_t count = 0;
  double fraction = 0;
  do {
    if (count == parts.size()) {  // milliseconds behind a colon
      const std::size_t before = text.size();
      const auto milliseconds = take_number(text, 3);
      if (!milliseconds || before - text.size() != 3) return std::nullopt;
      fraction = 1e-3 * *milliseconds;
      break;
    }
    const auto part = take_number(text, 3);
    if (!part || (count > 0 && *part > 59)) return std::nullopt;
    parts[count++] = *part;
  } while (take(text, ':'));
  const auto decimals = take_fraction(text);
  if (count < 2 || !decimals || (*decimals > 0 && fraction > 0)) return std::nullopt;
  if (half_day == ' ') half_day = take_half_day(text);
  const auto zone = zone_s(text);
  if (!zone) return std::nullopt;
  if (half_day != ' ' && parts[0] <= 12) parts[0] = parts[0] % 12 + (half_day == 'p' ? 12 : 0);
  const bool has_hours = count == 3 || half_day != ' ';
  const int seconds = count == 3  ? 3600 * parts[0] + 60 * parts[1] + parts[2]
                      : has_hours ? 3600 * parts[0] + 60 * parts[1]
                                  : 60 * parts[0] + parts[1];
  return ClockTime{day_s * days.value_or(0) + seconds + fraction + *decimals - *zone, days        ? 0
                                                                                      : has_hours ? day_s
                                                                                                  : hour_s};
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
