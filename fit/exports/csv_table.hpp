#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// A unit as the end of a column's name: "ml" => "_ml", "N m-1" => "_N_per_m", a pure number nothing.
std::string unit_suffix(const std::string& unit);

/// A number with all its digits, NaN as nothing; a text, in quotes where it needs them.
std::string csv_cell(double value);
std::string csv_cell(const std::string& text);

/// Columns side by side, all as long as the first; one of another length, or empty, is left out.
class CsvTable {
 public:
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

  std::string csv() const;

 private:
  std::string header_;
  std::vector<std::string> cells_;
};

/// One member of each record.
template <class Record, class Member>
auto each(const std::vector<Record>& records, Member member) {
  std::vector<std::decay_t<std::invoke_result_t<Member, const Record&>>> values;
  for (const Record& record : records) values.push_back(std::invoke(member, record));
  return values;
}

std::string names_and_numbers(const std::vector<NamedValue>& numbers);
std::string series_over_time(const std::vector<double>& time_s, const std::vector<Series>& series);

}  // namespace trunk
