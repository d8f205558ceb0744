#include "io/column_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>

#include "io/message_text.hpp"

namespace trunk {
namespace {

struct Unit {
  std::string_view suffix, name;
  Quantity quantity;
  double to_si;
};

// Longer suffixes stand before the ones they end with: "_l_min" before "_min".
constexpr double litre = 1e-3, millilitre = 1e-6, minute = 60;
constexpr std::array known_units{
    Unit{"_ml_sec", "ml_s", Quantity::flow, millilitre},
    Unit{"_ml_s", "ml_s", Quantity::flow, millilitre},
    Unit{"_l_min", "L_min", Quantity::flow, litre / minute},
    Unit{"_l_sec", "L_s", Quantity::flow, litre},
    Unit{"_l_s", "L_s", Quantity::flow, litre},
    Unit{"_milliseconds", "ms", Quantity::time, 1e-3},
    Unit{"_msec", "ms", Quantity::time, 1e-3},
    Unit{"_ms", "ms", Quantity::time, 1e-3},
    Unit{"_minutes", "min", Quantity::time, minute},
    Unit{"_min", "min", Quantity::time, minute},
    Unit{"_seconds", "s", Quantity::time, 1},
    Unit{"_sec", "s", Quantity::time, 1},
    Unit{"_s", "s", Quantity::time, 1},
    Unit{"_millilitres", "ml", Quantity::volume, millilitre},
    Unit{"_milliliters", "ml", Quantity::volume, millilitre},
    Unit{"_ml", "ml", Quantity::volume, millilitre},
    Unit{"_litres", "L", Quantity::volume, litre},
    Unit{"_liters", "L", Quantity::volume, litre},
    Unit{"_l", "L", Quantity::volume, litre},
};

// Everything but ASCII letters, digits and the bytes of other scripts separates words.
std::string plain_name(std::string_view header) {
  std::string plain;
  for (const char c : header) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte))
      plain += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
    else if (!plain.empty() && plain.back() != '_')
      plain += '_';
  }
  if (plain.ends_with('_')) plain.pop_back();
  return plain;
}

// Levenshtein's distance: insertions, deletions and replacements from one word to the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::vector<std::string> expected_names(Quantity quantity) {
  if (quantity == Quantity::time) return {"time_s", "time_ms", "time_min"};
  if (quantity == Quantity::volume) return {"volume_ml", "volume_L"};
  return {"flow_L_s", "flow_L_min", "flow_ml_s"};
}

}  // namespace

ColumnName column_name(std::string_view header) {
  ColumnName column{std::string(header), plain_name(header), {}, {}, Quantity::unknown, 1};
  column.base = column.plain;
  const auto unit = std::find_if(known_units.begin(), known_units.end(), [&](const Unit& candidate) {
    return column.plain.ends_with(candidate.suffix);
  });
  if (unit == known_units.end()) return column;
  column.base.resize(column.plain.size() - unit->suffix.size());
  column.unit = unit->name;
  column.quantity = unit->quantity;
  column.to_si = unit->to_si;
  return column;
}

std::string suggestion(const std::vector<ColumnName>& columns, Quantity quantity) {
  const auto names = expected_names(quantity);
  const std::string base = column_name(names.front()).base;
  for (const auto& column : columns)
    if (column.plain == base)
      return "column " + excerpt(column.text) + " has no unit: name it " + names.front() + " or " + names[1];
  for (const auto& column : columns) {
    if (!column.plain.starts_with(base)) continue;
    if (column.quantity == quantity)
      return "if column " + excerpt(column.text) + " is meant, choose it by this name";
    return "the unit of column " + excerpt(column.text) + " is not known: convert it to " + names.front();
  }
  // Only of names that do not say their quantity: volume_m3 is one letter from volume_ml and no misspelling.
  for (const auto& column : columns)
    for (const auto& name : names)
      if (edit_distance(column.plain, column_name(name).plain) <= 2)
        return "if column " + excerpt(column.text) + " is meant, name it " + name;
  return "";
}

std::string list_of(const std::vector<ColumnName>& columns) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(columns.size(), most); ++i)
    list += (i > 0 ? ", " : "") + excerpt(columns[i].text);
  return columns.size() > most ? list + " and " + std::to_string(columns.size() - most) + " more" : list;
}

}  // namespace trunk
