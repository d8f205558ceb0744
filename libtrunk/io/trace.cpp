#include "io/trace.hpp"

#include <algorithm>
#include <cstdint>

#include "errors/input_error.hpp"
#include "io/delimited_text.hpp"
#include "io/message_text.hpp"
#include "io/text_file.hpp"
#include "io/trace_columns.hpp"

namespace trunk {
namespace {

constexpr std::size_t max_file_bytes = 200'000'000;
constexpr std::size_t min_samples = 10;
constexpr double max_gap_steps = 10, max_gap_s = 0.25;

Trace described_by(const TraceColumns& columns, const std::string& source) {
  Trace trace;
  trace.source = source;
  trace.notes = columns.notes;
  trace.kind = columns.all[columns.value].quantity == Quantity::flow ? SignalKind::flow : SignalKind::volume;
  trace.time_unit = columns.all[columns.time].unit;
  trace.value_unit = columns.all[columns.value].unit;
  return trace;
}

void check_increases(const Trace& trace, double time, const DelimitedText::Row& row,
                     const TraceColumns& columns) {
  const auto& name = columns.all[columns.time];
  if (trace.time_s.empty() || time > trace.time_s.back()) return;
  throw InputError(
      trace.source, row.line,
      "time " + number_text(time / name.to_si, 10) + " found after " +
          number_text(trace.time_s.back() / name.to_si, 10) + " in column " + excerpt(name.text) +
          "; expected times that increase from row to row; sort the rows or split joined recordings");
}

double positive_sigma(const DelimitedText& table, const DelimitedText::Row& row, std::size_t column) {
  const double sigma = table.number(row, column);
  if (sigma > 0) return sigma;
  throw InputError(table.source(), row.line,
                   "sigma " + number_text(sigma) +
                       " found; expected a standard deviation above 0; correct it or "
                       "remove the column");
}

// The lines of the samples go to `lines`, for messages of later checks.
Trace read_samples(DelimitedText& table, const TraceColumns& columns, std::vector<std::uint32_t>& lines) {
  Trace trace = described_by(columns, table.source());
  DelimitedText::Row row;
  while (table.next(row)) {
    const double time = table.number(row, columns.time) * columns.all[columns.time].to_si;
    check_increases(trace, time, row, columns);
    trace.time_s.push_back(time);
    trace.value.push_back(table.number(row, columns.value) * columns.all[columns.value].to_si);
    if (columns.sigma)
      trace.sigma_m3.push_back(positive_sigma(table, row, *columns.sigma) *
                               columns.all[*columns.sigma].to_si);
    lines.push_back(static_cast<std::uint32_t>(row.line));
  }
  return trace;
}

void check_enough_samples(const Trace& trace, std::size_t header_line) {
  const std::size_t samples = trace.time_s.size();
  if (samples == 0)
    throw InputError(trace.source, header_line,
                     "a header without rows of numbers below it; expected at least " +
                         std::to_string(min_samples) + " samples; check that the export was finished");
  if (samples < min_samples)
    throw InputError(trace.source, 0,
                     std::to_string(samples) + (samples == 1 ? " sample" : " samples") +
                         " found; expected at least " + std::to_string(min_samples) +
                         "; give a recording of one breath or more");
}

double median_step(const std::vector<double>& time) {
  std::vector<double> steps(time.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = time[i + 1] - time[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

void check_gaps(const Trace& trace, const std::vector<std::uint32_t>& lines) {
  const double step = median_step(trace.time_s);
  for (std::size_t i = 1; i < trace.time_s.size(); ++i) {
    const double gap = trace.time_s[i] - trace.time_s[i - 1];
    if (gap <= max_gap_steps * step || gap <= max_gap_s) continue;
    throw InputError(trace.source, lines[i],
                     "a gap of " + number_text(gap) + " s between " + number_text(trace.time_s[i - 1], 8) +
                         " s and " + number_text(trace.time_s[i], 8) + " s; expected samples every " +
                         number_text(step) + " s; give the part before or after it as a file of its own");
  }
}

}  // namespace

Trace read_trace(const std::filesystem::path& path, const TraceOptions& options) {
  DelimitedText table(path.string(), read_text_file(path, max_file_bytes));
  const TraceColumns columns = choose_columns(table, options);
  std::vector<std::uint32_t> lines;
  Trace trace = read_samples(table, columns, lines);
  check_enough_samples(trace, table.header_line());
  check_gaps(trace, lines);
  return trace;
}

}  // namespace trunk
