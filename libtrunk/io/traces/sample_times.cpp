#include "traces/sample_times.hpp"

#include <algorithm>
#include <cmath>

#include "math/median.hpp"
#include "text/message_text.hpp"

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

// Least squares through the samples at which the clock moves on: those are within a step of its time, the
// others anywhere in its resolution.
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
      std::to_string(shared) + " samples share the time of the one before: the clock's resolution is " +
      number_text(resolution) + " s; spread evenly, " + number_text(1 / course.step) + " a second");
}

void check_gaps(const Times& time, double step, const RawSamples& samples) {
  Mistakes mistakes;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double gap = time[i] - time[i - 1];
    if (gap <= max_gap_steps * step || gap <= max_gap_s) continue;
    mistakes.add(samples
                     .error(i, "a gap of " + number_text(gap) + " s between " + number_text(time[i - 1], 8) +
                                   " s and " + number_text(time[i], 8) + " s; expected samples every " +
                                   number_text(step) +
                                   " s; give the part before or after it as a file of its own")
                     .mistake());
  }
  mistakes.settle();
}

// Where the times would make sense in another unit, that is what was meant.
std::string hint_for(double step, const ColumnName* column) {
  if (column && column->unit == "s" && step / 1e3 <= 1 / lowest_rate_hz)
    return "the column named in seconds may hold milliseconds: name it time_ms or add --time-unit ms";
  if (column && column->unit == "min" && step / 60 <= 1 / lowest_rate_hz)
    return "the column named in minutes may hold seconds: name it time_s or add --time-unit s";
  return column ? "give a recording of breathing and not of its averages" : "correct the rate";
}

void check_rate(double step, const RawSamples& samples, const ColumnName* column,
                std::vector<std::string>& notes) {
  const double rate = 1 / step;
  if (rate < lowest_rate_hz * (1 - 1e-6))
    throw samples.error_of_all("a sample every " + number_text(step) + " s found; expected at least " +
                               number_text(lowest_rate_hz) + " a second; " + hint_for(step, column));
  if (rate < usual_low_hz * (1 - 1e-6))
    notes.push_back("only " + number_text(rate) +
                    " samples a second: times of breaths are no better than the steps between them");
  if (rate > usual_high_hz * (1 + 1e-6))
    notes.push_back(number_text(rate) +
                    " samples a second are more than breathing has; is the unit of time right?");
}

}  // namespace

void check_increases(const Times& time, const RawSamples& samples, const ColumnName& column) {
  Mistakes mistakes;
  double last = -INFINITY;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] <= last)
      mistakes.add(samples
                       .error(i, "time " + number_text(time[i] / column.to_si, 10) + " found after " +
                                     number_text(last / column.to_si, 10) + " in " + samples.word() + " " +
                                     excerpt(column.text) +
                                     "; expected times that increase from row to row; sort the rows or split "
                                     "joined recordings")
                       .mistake());
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
  const double step = upper_median(steps_of(time_s));
  Mistakes mistakes;
  mistakes.gather([&] { check_rate(step, samples, column, notes); });
  mistakes.gather([&] { check_gaps(time_s, step, samples); });
  mistakes.settle();
}

}  // namespace trunk
