#include "commands/text/validation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/text/output.hpp"
#include "validation/usual_ranges.hpp"

namespace trunk {
namespace {

/// Returns 0 if the number is 0 to the digits shown, so that no "-0.00" is printed.
double without_negative_zero(double value, int decimals) {
  return std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
}

std::string cell(double value, int decimals, bool with_sign) {
  if (!std::isfinite(value)) return fmt::format(" {:>8}", "unknown");
  value = without_negative_zero(value, decimals);
  return with_sign ? fmt::format(" {:>+8.{}f}", value, decimals) : fmt::format(" {:>8.{}f}", value, decimals);
}

std::string table1_text(const ValidationRun& f) {
  std::string text = fmt::format("{:<24}", "Quiet breathing");
  for (const Table1Column& column : table1_columns()) text += fmt::format(" {:>8}", column.title);
  const std::vector<Table1Source> rows = table1_rows(f);
  for (const Table1Source& source : rows) {
    text += fmt::format("\n{:<24}", source.title);
    for (const Table1Column& column : table1_columns())
      text += cell(source.row->*column.value, column.decimals, false);
  }
  text +=
      "\nError against the experiment, % (where the experiment is 0: the difference, in the column's unit)";
  for (const Table1Source& source : std::span(rows).subspan(1)) {
    text += fmt::format("\n{:<24}", source.title);
    for (const Table1Column& column : table1_columns())
      text += cell(error_of(column, *source.row, f.paper.experiment).value, 2, true);
  }
  return text + "\n";
}

/// Returns how far a dome descends.
std::string dome_text(double mm) {
  return shown(without_negative_zero(mm, 2), "{:+.2f}");
}

/// Returns a row for every simulated breath. A paralysed one is also given in percent of its healthy twin.
std::string breaths_text(const ValidationRun& f) {
  std::string text = fmt::format("{0:<30} {1:8} {1:8} {1:8} {2:>18} {3:>17}\n", "Domes: positive descends",
                                 "", "at peak volume, mm", "most risen, mm");
  text += fmt::format("{:<30} {:>8} {:>8} {:>9} {:>8} {:>8} {:>8} {:>8} {:>12}\n", "", "start", "dV ml",
                      "% of twin", "right", "left", "right", "left", "volume error");
  for (const ValidatedScenario& scenario : validated_scenarios()) {
    const ValidatedBreath& breath = f.*scenario.breath;
    std::string of_twin;
    for (const ParalysedPair& pair : paralysed_pairs())
      if (pair.breath == scenario.breath) of_twin = shown(pair.volume_percent(f), "{:.1f}");
    text += fmt::format("{:<30} {:>8} {:>8} {:>9} {:>8} {:>8} {:>8} {:>8} {:>12}\n", scenario.name,
                        breath.start == Start::rest ? "rest" : "periodic", shown(breath.row.dv_ml, "{:.1f}"),
                        of_twin, dome_text(breath.right_dome_mm), dome_text(breath.left_dome_mm),
                        dome_text(breath.right_most_risen_mm), dome_text(breath.left_most_risen_mm),
                        shown(breath.volume_error, "{:.1e}"));
  }
  return text;
}

/// Returns a row of usual numbers, a row for every breath with a lung, and where the ranges come from; "" if
/// no scenario has a lung.
std::string pressures_text(const ValidationRun& f) {
  std::string head = fmt::format("{:<30}", "Swings, and recoil time"), sources,
              usual = fmt::format("\n{:<30}", "usual in quiet breathing"), rows;
  const auto width = [](const UsualRange& r) { return 3 + r.title.size() + r.unit.size(); };
  for (const UsualRange& r : usual_ranges()) {
    head += fmt::format("{:>{}}", fmt::format("{} {}", r.title, r.unit), width(r));
    usual += fmt::format("{:>{}}", fmt::format("{:g} to {:g}", r.low, r.high), width(r));
    sources += fmt::format("  {}: {}.\n", r.title, r.source);
  }
  for (const ValidatedScenario& scenario : validated_scenarios()) {
    const ValidatedBreath& breath = f.*scenario.breath;
    if (!breath.lung) continue;
    rows += fmt::format("\n{:<30}", scenario.name);
    for (const UsualRange& r : usual_ranges())
      rows += fmt::format("{:>{}}", shown(breath.*r.value, "{:.2f}"), width(r));
  }
  return rows.empty() ? "" : head + usual + rows + "\n" + sources + "\n";
}

std::string bounds_text(std::span<const Judged> results) {
  std::string text = fmt::format("{:<60} {:>10} {:>18}\n", "Bound", "value", "allowed");
  for (const Judged& r : results)
    text += fmt::format("{:<60} {:>10} {:>18} {:<8} {}\n", r.bound.meaning, shown(r.value, "{:.3g}"),
                        limits_text(r.bound), r.bound.unit == "1" ? "" : r.bound.unit,
                        r.pass ? "holds" : "FAILS");
  return text;
}

}  // namespace

std::vector<Table1Source> table1_rows(const ValidationRun& f) {
  return {{"experiment", "experiment", &f.paper.experiment},
          {"published_model", "published model", &f.paper.published_model},
          {"published_healthy", "ours, published_healthy", &f.published_healthy.row},
          {"healthy", "ours, healthy", &f.healthy.row},
          {"craighero", "ours, craighero", &f.craighero.row}};
}

std::string validation_text(const ValidationRun& findings, std::span<const Judged> results) {
  const auto failed = std::count_if(results.begin(), results.end(), [](const Judged& r) { return !r.pass; });
  return table1_text(findings) + "\n" + breaths_text(findings) + "\n" + pressures_text(findings) +
         bounds_text(results) +
         (failed == 0 ? fmt::format("All {} bounds hold.", results.size())
                      : fmt::format("{} of {} bounds fail.", failed, results.size()));
}

}  // namespace trunk
