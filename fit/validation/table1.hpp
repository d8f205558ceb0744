#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// One row of the paper's Table 1: a quiet breath, measured or simulated. Signs as in Measures: positive
/// where the zone of apposition shortens (dL) and widens (dR), and where the domes flatten (dH).
struct Table1Row {
  double eev_ml = 0.0, eiv_ml = 0.0;     // end-expiratory and end-inspiratory lung volume
  double dv_ml = 0.0, dv_percent = 0.0;  // of the end-expiratory volume
  double dl_mm = 0.0, dl_percent = 0.0;  // of the length at end-expiration
  double dh_mm = 0.0, dr_mm = 0.0;
};

/// A column of Table 1: the only place that knows its names, its unit and how it is shown.
struct Table1Column {
  std::string_view csv;      // in reference/table1.csv
  std::string_view measure;  // in `simulate --json`
  std::string_view title;    // at the head of a printed table
  std::string_view unit;
  int decimals;  // as the paper prints it, one more for volumes
  double Table1Row::*value;
};
std::span<const Table1Column> table1_columns();

/// What the paper printed.
struct Table1 {
  Table1Row experiment, published_model;
};

/// Reads reference/table1.csv: a column `source` and all of table1_columns(), the rows `experiment` and
/// `published_model`, each once. Throws InputError with file and line on anything else, on end-expiratory
/// volumes that are not above 0, and on a dV that is not the difference of the volumes within what rounding
/// allows.
Table1 read_table1(const std::filesystem::path& path);

/// The row of a simulated breath from its measures_of(). NaN where the breath did not end.
Table1Row row_of(std::span<const NamedValue> measures);

/// How far a value is from the experiment's. Percent of the latter; where that is 0 (dR), the difference in
/// the column's own unit.
struct Table1Error {
  double value;
  bool relative;  // false: a difference
};
Table1Error error_of(const Table1Column& column, const Table1Row& row, const Table1Row& experiment);

}  // namespace trunk
