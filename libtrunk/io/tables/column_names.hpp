#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tables/unit_text.hpp"

namespace trunk {

/// The content of a column header: `volume_L`, `Volume [L]` and `"VOLUME (l)"` all have base "volume" and
/// unit "L".
struct ColumnName {
  std::string text;                       ///< as in the file
  std::string plain;                      ///< lower case, words joined by '_': "flow_l_s"
  std::string base;                       ///< plain without its unit: "flow"
  std::string unit;                       ///< as in this program: "L_s"; empty if there is none
  Quantity quantity = Quantity::unknown;  ///< by the unit
  double to_si = 1;                       ///< factor from the unit to s, m3, m3/s, Pa or m
  /// What looks like a unit and is none that is known, or may mean two; empty: nothing. A column with such a
  /// unit must not be used unless the user gives the unit.
  std::string unclear;

  void set(const Unit& known);  ///< also clears `unclear`

  /// Returns `unclear`, or a unit of its own that looks like one and is not known; "" if there is no doubt.
  std::string doubtful_unit() const;
};

/// Reads a header (UTF-8, any case). The unit is at the end of the name or in brackets. The units are us, ms,
/// s, min, h; ml, cl, dl, L, m3 (cm3 and cc are ml); a volume over a time; cmH2O, mbar, hPa, kPa, Pa, mmHg
/// (also torr); mm, cm; and their spellings in words. In brackets a unit may have a factor (see unit_of). A
/// factor outside of brackets ("Flow 10 mL/s") may be the number of a channel and makes the unit unclear, but
/// for single digits. A name may consist of only a unit.
ColumnName column_name(std::string_view header);

enum class Role { time, flow, volume, belt };
/// Returns the role of a column according to its name without the unit, in English, German, French, Spanish,
/// Italian, Portuguese, Dutch, Swedish, and a word or two in a dozen others. Words that do not change the
/// meaning ("airway", "sensor", numbers) are ignored. Returns nothing if the column may be another quantity,
/// such as a peak flow.
std::optional<Role> role_of(const ColumnName& column);

enum class TrunkPart { thorax, abdomen };
/// Returns the part of the trunk that a belt goes around according to its name; nothing if the name does not
/// say it.
std::optional<TrunkPart> part_of_trunk(const ColumnName& belt);

/// Returns whether the name is a documented one: time, t, flow or volume with a unit.
bool is_documented(const ColumnName& column);

/// Returns a sentence that names the column which is probably meant as `quantity` and its right name, or "".
std::string suggestion(const std::vector<ColumnName>& columns, Quantity quantity);

/// Returns how the user can say which unit of time, flow or volume a column has.
std::string how_to_give_a_unit(Quantity quantity);

/// Returns the headers of a file for an error text: "'a', 'b', 'c'". Long lists are cut.
std::string list_of(const std::vector<ColumnName>& columns);

}  // namespace trunk
