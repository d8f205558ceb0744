#include "traces/sample_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/median.hpp"
#include "text/message_text.hpp"
#include "traces/breath_table.hpp"

namespace trunk {
namespace {

constexpr double max_gap_steps = 10, max_gap_s = 0.25;
constexpr double lowest_rate_hz = 4, usual_low_hz = 10, usual_high_hz = 2000;

using Times = std::vector<double>;

Times steps_of(const Times& time) {
  Times steps(time.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = time[i + 1] - time[i];
  return steps;
}

struct Line {
  double start, step;
  double at(std::size_t i) const { return start + step * static_cast<double>(i); }
};

// Returns evenly spaced times by least squares through the samples at which the clock advances. Their times
// are right within one step; those of the other samples only within the resolution of the clock.
Line even_course(const Times& time) {
  std::vector<std::size_t> moves;
  for (std::size_t i = 1; i < time.size(); ++i)
    if (time[i] > time[i - 1]) moves.push_back(i);
  const auto n = static_cast<double>(moves.size());
  double mean_i = 0, mean_t = 0, covariance = 0, variance = 0;
  for (const std::size_t i : moves) {
    mean_i += static_cast<double>(i) / n;
    mean_t += time[i] / n;
  }
  for (const std::size_t i : moves) {
    const double di = static_cast<double>(i) - mean_i;
    covariance += di * (time[i] - mean_t);
    variance += di * di;
  }
  const double step = covariance / variance;
  return {mean_t - step * mean_i, step};
}

void spread_shared(Times& time, std::vector<std::string>& notes) {
  Times steps = steps_of(time);
  const auto shared = static_cast<std::size_t>(std::count(steps.begin(), steps.end(), 0.0));
  std::erase(steps, 0.0);
  if (shared < 3 || steps.size() < 3 || *std::min_element(steps.begin(), steps.end()) < 0) return;
  const double resolution = upper_median(steps);
  const Line course = even_course(time);
  for (std::size_t i = 0; i < time.size(); ++i)
    if (std::abs(time[i] - course.at(i)) > 1.01 * resolution) return;
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = course.at(i);
  notes.push_back(
      fmt::format("{} samples share the time of the one before, since the resolution of the clock is {} s; "
                  "all are spread evenly, {} a second",
                  shared, number_text(resolution), number_text(1 / course.step)));
}

void check_gaps(const Times& time, double step, const RawSamples& samples) {
  Mistakes mistakes;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double gap = time[i] - time[i - 1];
    if (gap <= max_gap_steps * step || gap <= max_gap_s) continue;
    mistakes.add(samples.mistake_at(i,
                                    fmt::format("a gap of {} s between {} s and {} s", number_text(gap),
                                                number_text(time[i - 1], 8), number_text(time[i], 8)),
                                    fmt::format("samples every {} s", number_text(step)),
                                    "give the part before or after it as its own file"));
  }
  mistakes.settle();
}

// If the times are plausible in another unit, the error suggests this unit.
std::string hint_for(double step, const Times& steps, const ColumnName* column,
                     const std::vector<ColumnName>& all) {
  // Breaths are not evenly spaced; samples are.
  const auto uneven =
      std::count_if(steps.begin(), steps.end(), [&](double s) { return std::abs(s - step) > 0.02 * step; });
  const bool rows_of_breaths = 2 * static_cast<std::size_t>(uneven) > steps.size();
  if (rows_of_breaths || !numbers_of_breaths(all).empty())
    return fmt::format("if each row is a breath, {}", remedy_for_breath_table);
  if (column && column->unit == "s" && step / 1e3 <= 1 / lowest_rate_hz)
    return "the column named in seconds may hold milliseconds: name it time_ms or add --time-unit ms";
  if (column && column->unit == "min" && step / 60 <= 1 / lowest_rate_hz)
    return "the column named in minutes may hold seconds: name it time_s or add --time-unit s";
  return column ? "give a recording of single breaths, not of averages" : "correct the rate";
}

void check_rate(double step, const Times& steps, const RawSamples& samples, const ColumnName* column,
                std::vector<std::string>& notes) {
  const double rate = 1 / step;
  if (rate < lowest_rate_hz * (1 - 1e-6))
    throw samples.error(fmt::format("a sample every {} s found", number_text(step)),
                        fmt::format("at least {} a second", number_text(lowest_rate_hz)),
                        hint_for(step, steps, column, samples.names()));
  if (rate < usual_low_hz * (1 - 1e-6))
    notes.push_back(fmt::format(
        "only {} samples a second: times of breaths are not more exact than the steps between samples",
        number_text(rate)));
  if (rate > usual_high_hz * (1 + 1e-6))
    notes.push_back(fmt::format(
        "{} samples a second are more than breathing needs; is the unit of time right?", number_text(rate)));
}

// Says where the sampling rate changes: by the mean rates of twenty parts, which jitter hardly moves.
void note_rates(const Times& time, std::vector<std::string>& notes) {
  constexpr std::size_t parts = 20, fewest = 20;
  constexpr double most = 1.3;
  if (time.size() < parts * fewest) return;
  std::vector<double> rates;
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t first = k * (time.size() - 1) / parts, end = (k + 1) * (time.size() - 1) / parts;
    rates.push_back(static_cast<double>(end - first) / (time[end] - time[first]));
  }
  const double usual = upper_median(rates), first = rates.front(), last = rates.back();
  if (std::max(first, last) < most * std::min(first, last)) return;
  std::size_t k = 0;
  while (k + 1 < parts && std::abs(std::log(rates[k] / first)) < std::abs(std::log(rates[k] / last))) ++k;
  const auto at =
      static_cast<std::size_t>(static_cast<double>(k) / parts * static_cast<double>(time.size() - 1));
  notes.push_back(fmt::format(
      "the sampling rate changes near {} s from {} to {} samples a second (usual: {}): are the "
      "times of both parts in one unit?",
      number_text(time[at], 3), number_text(first, 3), number_text(last, 3), number_text(usual, 3)));
}

}  // namespace

void check_increases(const Times& time, const RawSamples& samples, const ColumnName& column) {
  Mistakes mistakes;
  double last = -HUGE_VAL;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] <= last)
      mistakes.add(samples.mistake_at(
          i,
          fmt::format("time {} found after {} in {} {}", number_text(time[i] / column.to_si, 10),
                      number_text(last / column.to_si, 10), samples.word(), excerpt(column.text)),
          "times that increase from row to row", "sort the rows or split joined recordings"));
    if (std::isfinite(time[i])) last = time[i];
  }
  mistakes.settle();
}

void settle_times(std::vector<double>& time_s, const RawSamples& samples, const ColumnName* column,
                  std::vector<std::string>& notes) {
  if (column) {
    spread_shared(time_s, notes);
    check_increases(time_s, samples, *column);
  }
  const Times steps = steps_of(time_s);
  const double step = upper_median(steps);
  Mistakes mistakes;
  mistakes.gather([&] { check_rate(step, steps, samples, column, notes); });
  mistakes.gather([&] { check_gaps(time_s, step, samples); });
  mistakes.settle();
  if (column) note_rates(time_s, notes);
}

}  // namespace trunk
