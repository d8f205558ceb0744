#include "traces/raw_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/median.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

// Returns whether 49 of 50 steps are within a quarter of their median.
bool are_even(const std::vector<double>& steps) {
  const double median = upper_median(steps);
  const auto even = std::count_if(steps.begin(), steps.end(),
                                  [&](double step) { return std::abs(step - median) < median / 4; });
  return 50 * static_cast<std::size_t>(even) >= 49 * steps.size();
}

std::string count_of(std::size_t samples) {
  return fmt::format("{} sample{}", samples, samples == 1 ? "" : "s");
}

/// Returns the mistake of a sample as the first of many similar ones.
Mistake first_of(Mistake mistake, const std::string& many) {
  if (!many.empty()) mistake.found += fmt::format(" (the first of {})", many);
  return mistake;
}

}  // namespace

RawSamples::RawSamples(Recording& recording, const TraceColumns& columns)
    : recording_(recording), columns_(columns), chosen_{columns.value} {
  if (columns.time) chosen_.push_back(*columns.time);
  if (columns.sigma) chosen_.push_back(*columns.sigma);
  samples_ = recording.read(chosen_);
}

Mistake RawSamples::mistake_at(std::size_t sample, std::string found, std::string expected,
                               std::string remedy) const {
  const bool has_lines = !samples_.lines.empty();
  if (!has_lines) found = fmt::format("sample {}: {}", sample + 1, found);
  return {{recording_.source, has_lines ? samples_.lines[sample] : 0},
          std::move(found),
          std::move(expected),
          std::move(remedy),
          {}};
}

InputError RawSamples::error(std::string found, std::string expected, std::string remedy) const {
  return {{recording_.source}, std::move(found), std::move(expected), std::move(remedy)};
}

Mistake RawSamples::flaw(std::size_t sample) const {
  const auto known = std::lower_bound(samples_.flaws.begin(), samples_.flaws.end(), sample,
                                      [](const auto& f, std::size_t i) { return f.sample < i; });
  if (known != samples_.flaws.end() && known->sample == sample) return known->mistake;
  for (std::size_t row = 0; row < chosen_.size(); ++row)
    if (const double value = samples_.values[row][sample]; !std::isfinite(value))
      return mistake_at(sample,
                        fmt::format("{} found in {} {}", number_text(value), recording_.word,
                                    excerpt(columns_.all[chosen_[row]].text)),
                        "a finite number", "remove the sample or interpolate the value");
  return {};
}

void RawSamples::leave_out_other_rates(std::vector<std::string>& notes) {
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < size(); ++i)
    if (std::isfinite(samples_.values[0][i])) rows.push_back(static_cast<std::uint32_t>(i));
  const std::size_t left_out = size() - rows.size();
  if (10 * left_out <= size() || rows.size() < 10) return;
  // Many rows without a number at an end are no other rate.
  const std::size_t usual = (rows.back() - rows.front()) / (rows.size() - 1) + 1;
  if (rows.front() > 2 * usual || size() - 1 - rows.back() > 2 * usual) return;
  const auto step_of = [&](auto&& place) {
    std::vector<double> steps(rows.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = place(rows[i + 1]) - place(rows[i]);
    return steps;
  };
  const bool by_time = columns_.time && are_even(step_of([&](auto row) { return samples_.values[1][row]; }));
  if (!by_time && !are_even(step_of([](auto row) { return static_cast<double>(row); }))) return;
  used_.all_time_s = time_s();
  used_.rows = rows;
  for (auto& row : samples_.values) row = used_.of(row, rows.size());
  if (!samples_.lines.empty()) {
    for (std::size_t i = 0; i < rows.size(); ++i) samples_.lines[i] = samples_.lines[rows[i]];
    samples_.lines.resize(rows.size());
  }
  std::erase_if(samples_.flaws, [&](Samples::Flaw& flaw) {
    const auto row = std::lower_bound(rows.begin(), rows.end(), flaw.sample);
    const bool gone = row == rows.end() || *row != flaw.sample;
    if (!gone) flaw.sample = static_cast<std::size_t>(row - rows.begin());
    return gone;
  });
  notes.push_back(fmt::format("{} {} has a number in {} of {} rows, evenly spaced: the others are left out",
                              recording_.word, excerpt(columns_.all[columns_.value].text), rows.size(),
                              rows.size() + left_out));
}

std::vector<RawSamples::Run> RawSamples::runs_without_number() const {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < size(); ++i) {
    const bool whole = std::all_of(samples_.values.begin(), samples_.values.end(),
                                   [&](const auto& row) { return std::isfinite(row[i]); });
    if (whole) continue;
    if (runs.empty() || runs.back().end != i) runs.push_back({i, i});
    runs.back().end = i + 1;
  }
  return runs;
}

// Returns the median over steps as wide as a tenth of the recording, which is robust against single wrong
// times and a coarse clock; infinite if the times do not increase.
double RawSamples::step_s() const {
  if (!columns_.time) {
    const auto& rows = used_.rows;
    const double spacing = rows.size() < 2 ? 1
                                           : static_cast<double>(rows.back() - rows.front()) /
                                                 static_cast<double>(rows.size() - 1);
    return spacing / columns_.rate_hz;
  }
  const std::vector<double>& time = samples_.values[1];
  const std::size_t width = std::max<std::size_t>(time.size() / 10, 1);
  std::vector<double> steps;
  for (std::size_t i = width; i < time.size(); ++i)
    if (std::isfinite(time[i] - time[i - width]))
      steps.push_back((time[i] - time[i - width]) / static_cast<double>(width));
  if (steps.empty()) return INFINITY;
  const double step = upper_median(std::move(steps));
  return step > 0 ? step * columns_.all[*columns_.time].to_si : INFINITY;
}

void RawSamples::bridge_missing(std::vector<std::string>& notes) {
  const std::vector<Run> runs = runs_without_number();
  if (runs.empty()) return;
  const auto longest = static_cast<std::size_t>(std::clamp(longest_bridge_s / step_s() + 1e-9, 1.0, 1e9));
  Mistakes mistakes;
  std::size_t missing = 0;
  for (const Run& run : runs) {
    missing += run.end - run.begin;
    if (run.end - run.begin <= longest) continue;
    const std::size_t count = run.end - run.begin;
    mistakes.add(first_of(flaw(run.begin), count > 1 ? fmt::format("{} in a row", count_of(count)) : ""));
  }
  if (mistakes.empty() && 10 * missing > size())
    mistakes.add(
        first_of(flaw(runs.front().begin), fmt::format("{}, more than a tenth of all", count_of(missing))));
  mistakes.settle();

  note(runs, notes);
  for (auto run = runs.rbegin(); run != runs.rend();
       ++run)  // from the end, so that earlier positions stay valid
    at_an_end(*run) ? leave_out(*run) : interpolate(*run);
}

void RawSamples::note(const std::vector<Run>& runs, std::vector<std::string>& notes) const {
  for (const bool end : {false, true}) {
    std::size_t count = 0, first = 0;
    for (const Run& run : runs) {
      if (at_an_end(run) != end) continue;
      if (count == 0) first = run.begin;
      count += run.end - run.begin;
    }
    if (count == 0) continue;
    const Mistake cause = flaw(first);
    notes.push_back(fmt::format("{} without a number {}{}{}: {}", count_of(count),
                                end ? "at an end of the recording left out" : "interpolated",
                                count > 1 ? "; the first: " : ": ", cause.at.text(), cause.found));
  }
}

void RawSamples::interpolate(const Run& run) {
  for (auto& row : samples_.values) {
    const double before = row[run.begin - 1], after = row[run.end];
    const auto steps = static_cast<double>(run.end - run.begin + 1);
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (!std::isfinite(row[i]))
        row[i] = before + (after - before) * static_cast<double>(i - run.begin + 1) / steps;
  }
}

void RawSamples::leave_out(const Run& run) {
  const auto cut = [&](auto& row) {
    row.erase(row.begin() + static_cast<std::ptrdiff_t>(run.begin),
              row.begin() + static_cast<std::ptrdiff_t>(run.end));
  };
  if (run.begin == 0) used_.first += run.end;
  for (auto& row : samples_.values) cut(row);
  if (!samples_.lines.empty()) cut(samples_.lines);
}

std::vector<double> RawSamples::scaled(std::size_t row, std::size_t column) const {
  std::vector<double> values = samples_.values[row];
  for (double& value : values) value *= columns_.all[column].to_si;
  return values;
}

std::vector<double> RawSamples::value() const {
  return scaled(0, columns_.value);
}

std::vector<double> RawSamples::time_s() const {
  if (columns_.time) return scaled(1, *columns_.time);
  std::vector<double> time(size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    const std::size_t row = used_.rows.empty() ? i : used_.rows[used_.first + i] - used_.rows[used_.first];
    time[i] = static_cast<double>(row) / columns_.rate_hz;
  }
  return time;
}

std::vector<double> RawSamples::time_of_whole_samples_s() const {
  std::vector<double> time = time_s();
  for (const Run& run : runs_without_number())
    std::fill(time.begin() + static_cast<std::ptrdiff_t>(run.begin),
              time.begin() + static_cast<std::ptrdiff_t>(run.end), NAN);
  return time;
}

std::vector<double> RawSamples::sigma_m3() const {
  return columns_.sigma ? scaled(chosen_.size() - 1, *columns_.sigma) : std::vector<double>{};
}

}  // namespace trunk
