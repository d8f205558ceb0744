#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// One row of the paper's Table 1: a quiet breath, measured or simulated. Signs are as in Measures: dL is
/// positive if the zone of apposition shortens, dR if it widens, and dH if the domes flatten.
struct Table1Row {
  double eev_ml = 0.0, eiv_ml = 0.0;     // end-expiratory and end-inspiratory lung volume
  double dv_ml = 0.0, dv_percent = 0.0;  // of the end-expiratory volume
  double dl_mm = 0.0, dl_percent = 0.0;  // of the length at end-expiration
  double dh_mm = 0.0, dr_mm = 0.0;
};

/// A column of Table 1. Only this table knows its names, its unit and its digits.
struct Table1Column {
  std::string_view csv;      // in reference/table1.csv
  std::string_view measure;  // in `simulate --json`
  std::string_view title;    // at the head of a printed table
  std::string_view unit;
  int decimals;  // as the paper prints it, one more for volumes
  double Table1Row::*value;
};
std::span<const Table1Column> table1_columns();

/// The two rows that the paper prints.
struct Table1 {
  Table1Row experiment, published_model;
};

/// Reads reference/table1.csv: a column `source` and all of table1_columns(), and one row each for
/// `experiment` and `published_model`. Throws InputError with file and line if the table holds anything else,
/// if an end-expiratory volume is not above 0, or if dV is not the difference of the volumes within rounding.
Table1 read_table1(const std::filesystem::path& path);

/// Returns the row of a simulated breath from its measures (see measures_of); a missing measure is NaN.
Table1Row row_of(std::span<const NamedValue> measures);

/// The difference of a value from the experiment's: in percent of the experiment's value, or, if that is 0
/// (dR), in the column's own unit.
struct Table1Error {
  double value;
  bool relative;  // false: a difference
};
Table1Error error_of(const Table1Column& column, const Table1Row& row, const Table1Row& experiment);

}  // namespace trunk
