#include "validation/table1.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "tables/delimited_text.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t max_file_bytes = 100'000;
constexpr double volume_rounding_ml = 1.5;  // three printed numbers, each to the ml
constexpr std::string_view source_column = "source";

constexpr Table1Column columns[] = {
    {"eev_ml", "end_expiratory_volume_ml", "EEV ml", "ml", 1, &Table1Row::eev_ml},
    {"eiv_ml", "end_inspiratory_volume_ml", "EIV ml", "ml", 1, &Table1Row::eiv_ml},
    {"dv_ml", "delta_v_ml", "dV ml", "ml", 1, &Table1Row::dv_ml},
    {"dv_percent", "delta_v_percent", "dV %", "percent", 2, &Table1Row::dv_percent},
    {"dl_mm", "delta_l_mm", "dL mm", "mm", 2, &Table1Row::dl_mm},
    {"dl_percent", "delta_l_percent", "dL %", "percent", 2, &Table1Row::dl_percent},
    {"dh_mm", "delta_h_mm", "dH mm", "mm", 2, &Table1Row::dh_mm},
    {"dr_mm", "delta_r_mm", "dR mm", "mm", 2, &Table1Row::dr_mm}};

std::string expected_header() {
  std::string text(source_column);
  for (const Table1Column& column : columns) text += "," + std::string(column.csv);
  return text;
}

/// Returns the position of each column in the file; throws InputError if a column is unknown, missing or
/// doubled.
std::map<std::string_view, std::size_t> places_of(const DelimitedText& table) {
  std::map<std::string_view, std::size_t> places;
  const auto fail = [&](const std::string& found) {
    throw InputError({table.source(), table.header_line()}, found, expected_header());
  };
  for (std::size_t i = 0; i < table.names().size(); ++i) {
    const std::string& name = table.names()[i];
    const bool known = name == source_column || std::any_of(std::begin(columns), std::end(columns),
                                                            [&](const auto& c) { return c.csv == name; });
    if (!known) fail("unknown column " + excerpt(name));
    if (!places.emplace(name, i).second) fail("column " + excerpt(name) + " found twice");
  }
  if (!places.contains(source_column)) fail("no column 'source'");
  for (const Table1Column& column : columns)
    if (!places.contains(column.csv)) fail("no column '" + std::string(column.csv) + "'");
  return places;
}

void require_consistent(const Table1Row& row, const std::string& source, std::size_t line) {
  if (!(row.eev_ml > 0.0))
    throw InputError({source, line}, "eev_ml is " + number_text(row.eev_ml), "a volume above 0");
  const double difference = row.eiv_ml - row.eev_ml;
  if (!(std::abs(row.dv_ml - difference) <= volume_rounding_ml))
    throw InputError({source, line}, "dv_ml is " + number_text(row.dv_ml, 6),
                     "eiv_ml - eev_ml, which is " + number_text(difference, 6));
}

Table1Row read_row(const DelimitedText& table, const DelimitedText::Row& cells,
                   const std::map<std::string_view, std::size_t>& places) {
  Table1Row row;
  for (const Table1Column& column : columns) row.*column.value = table.number(cells, places.at(column.csv));
  require_consistent(row, table.source(), cells.line);
  return row;
}

}  // namespace

std::span<const Table1Column> table1_columns() {
  return columns;
}

Table1 read_table1(const std::filesystem::path& path) {
  DelimitedText table(path.string(), read_text_file(path, max_file_bytes));
  const auto places = places_of(table);
  std::map<std::string_view, std::optional<Table1Row>> rows{{"experiment", {}}, {"published_model", {}}};
  DelimitedText::Row cells;
  while (table.next(cells)) {
    const std::size_t place = places.at(source_column);
    const std::string_view source = place < cells.cells.size() ? cells.cells[place] : "";
    const auto row = rows.find(source);
    if (row == rows.end() || row->second)
      throw InputError({table.source(), cells.line},
                       "source " + excerpt(source) + (row == rows.end() ? " found" : " found twice"),
                       "one row 'experiment' and one 'published_model'");
    row->second = read_row(table, cells, places);
  }
  for (const auto& [source, row] : rows)
    if (!row)
      throw InputError({table.source()}, "no row with source '" + std::string(source) + "'", "", "add it");
  return {*rows.at("experiment"), *rows.at("published_model")};
}

Table1Row row_of(std::span<const NamedValue> measures) {
  Table1Row row;
  for (const Table1Column& column : columns) {
    const auto found = std::find_if(measures.begin(), measures.end(),
                                    [&](const NamedValue& v) { return v.name == column.measure; });
    row.*column.value = found == measures.end() ? std::nan("") : found->value;
  }
  return row;
}

Table1Error error_of(const Table1Column& column, const Table1Row& row, const Table1Row& experiment) {
  const double value = row.*column.value, reference = experiment.*column.value;
  if (reference == 0.0) return {value - reference, false};
  return {100.0 * (value / reference - 1.0), true};
}

}  // namespace trunk
