#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// Returns the ending of a column's name for a unit: "_ml" for "ml", "_N_per_m" for "N m-1", "" for a pure
/// number.
std::string unit_suffix(const std::string& unit);

/// Returns a number with all its digits, or "" for NaN.
std::string csv_cell(double value);
/// Returns a text, in quotes if it holds commas, quotes or line ends.
std::string csv_cell(const std::string& text);

/// A table of columns, all as long as the first one.
class CsvTable {
 public:
  /// Adds a column. A column that is empty, or not as long as the first one, is left out.
  template <class Value>
  void add(const std::string& name, const std::string& unit, const std::vector<Value>& values) {
    if (values.empty() || (!cells_.empty() && values.size() != cells_.size())) return;
    cells_.resize(values.size());
    const char* comma = header_.empty() ? "" : ",";
    header_ += comma + csv_cell(name + unit_suffix(unit));
    for (std::size_t row = 0; row < values.size(); ++row) {
      if constexpr (std::is_arithmetic_v<Value>)
        cells_[row] += comma + csv_cell(static_cast<double>(values[row]));
      else
        cells_[row] += comma + csv_cell(values[row]);
    }
  }

  /// Returns the header and the rows.
  std::string csv() const;

 private:
  std::string header_;
  std::vector<std::string> cells_;
};

/// Returns one member of each record; `member` is a pointer to a member or a function.
template <class Record, class Member>
auto each(const std::vector<Record>& records, Member member) {
  std::vector<std::decay_t<std::invoke_result_t<Member, const Record&>>> values;
  for (const Record& record : records) values.push_back(std::invoke(member, record));
  return values;
}

/// Returns a table with the columns name, value and unit.
std::string names_and_numbers(const std::vector<NamedValue>& numbers);

/// Returns a table with one row for each choice of the model: its keys and range, and a column share_X for
/// each number X that has a structural interval.
std::string choices_and_shares(const Structure& structure);

/// Returns a table with a column of times, s, and one column for each series.
std::string series_over_time(const std::vector<double>& time_s, const std::vector<Series>& series);

}  // namespace trunk
