#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trunk {

enum class Quantity { time, volume, flow, unknown };

struct Unit {
  std::string_view name;  ///< as this program writes it: "L_s"
  Quantity quantity;
  double to_si;  ///< factor to s, m3 or m3/s
};

/// A unit alone, "L/s", "[l/min]", "mL": one of the known ones, in any spelling of column_name; or nothing.
std::optional<Unit> unit_of(std::string_view text);

/// What a column header says: `volume_L`, `Volume [L]` and `"VOLUME (l)"` all read base "volume", unit "L".
struct ColumnName {
  std::string text;                       ///< as in the file
  std::string plain;                      ///< lower case, words joined by '_': "flow_l_s"
  std::string base;                       ///< plain without its unit: "flow"
  std::string unit;                       ///< as this program writes it: "L_s"; empty when there is none
  Quantity quantity = Quantity::unknown;  ///< by the unit
  double to_si = 1;                       ///< factor from the unit to s, m3 or m3/s

  void set(const Unit& known);
};

/// Reads a header (UTF-8, any case). The unit ends the name or stands in brackets: us ms s min h; ml cl dl L
/// m3 (cm3 and cc are ml); ml_s L_s L_min ml_min m3_s, and their spellings in words. A unit may be all of the
/// name.
ColumnName column_name(std::string_view header);

/// What a column is by its name, without its unit: in English, German, French, Spanish, Italian, Portuguese,
/// Dutch and Swedish; words that do not change the meaning ("airway", "sensor", numbers) are passed over.
/// Nothing where it may be another quantity, such as a peak flow.
enum class Role { time, flow, volume, belt };
std::optional<Role> role_of(const ColumnName& column);

/// Whether the name is one of ours: time, t, flow or volume, and a unit.
bool is_documented(const ColumnName& column);

/// A sentence that names the column which was probably meant as `quantity` and its right name, or "".
std::string suggestion(const std::vector<ColumnName>& columns, Quantity quantity);

/// "'a', 'b', 'c'": the headers of a file for an error text; long lists are cut.
std::string list_of(const std::vector<ColumnName>& columns);

}  // namespace trunk
