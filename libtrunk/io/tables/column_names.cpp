#include "tables/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "tables/column_vocabulary.hpp"
#include "text/edit_distance.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

// Returns a header in lower case, with "_" for all characters that separate words. Letters are those of ASCII
// and all bytes of other scripts. Capitals of western Europe (U+00C0 to U+00DE) become lower case too.
std::string plain_name(std::string_view header) {
  std::string plain;
  unsigned char before = 0;
  for (const char c : header) {
    const auto byte = static_cast<unsigned char>(c);
    const bool capital = before == 0xC3 && byte >= 0x80 && byte <= 0x9E && byte != 0x97;
    if (byte >= 0x80)
      plain += static_cast<char>(capital ? byte + 0x20 : byte);
    else if (std::isalnum(byte))
      plain += static_cast<char>(std::tolower(byte));
    else if (!plain.empty() && plain.back() != '_')
      plain += '_';
    before = byte;
  }
  if (plain.ends_with('_')) plain.pop_back();
  return plain;
}

std::string without_conditions(std::string plain) {
  for (const std::string_view condition : gas_conditions())
    if (plain.ends_with(condition)) plain.resize(plain.size() - condition.size());
  return plain;
}

const UnitSpelling* ending_of(std::string_view plain) {
  const UnitSpelling* longest = nullptr;
  for (const UnitSpelling& spelling : unit_spellings())
    if (plain.ends_with(spelling.suffix) && (!longest || spelling.suffix.size() > longest->suffix.size()))
      longest = &spelling;
  return longest;
}

struct Brackets {
  Unit unit;
  std::string rest;
};

// Returns L_s and "Flow  at the mouth" for "Flow [L/s] at the mouth".
std::optional<Brackets> unit_in_brackets(std::string_view header) {
  for (auto open = header.find_first_of("[("); open != std::string_view::npos;
       open = header.find_first_of("[(", open + 1)) {
    const auto close = header.find_first_of("])", open);
    if (close == std::string_view::npos) return std::nullopt;
    if (const auto unit = unit_of(header.substr(open, close - open)))
      return Brackets{*unit,
                      std::string(header.substr(0, open)) + " " + std::string(header.substr(close + 1))};
  }
  return std::nullopt;
}

std::vector<std::string_view> parts_of(std::string_view base) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start < base.size();) {
    const auto end = std::min(base.find('_', start), base.size());
    parts.push_back(base.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

bool is_ignored(std::string_view part) {
  const auto words = ignored_words();
  return std::find(words.begin(), words.end(), part) != words.end() ||
         part.find_first_not_of("0123456789") == std::string_view::npos ||
         (part.starts_with("ch") && part.find_first_not_of("0123456789", 2) == std::string_view::npos);
}

std::vector<std::string> expected_names(Quantity quantity) {
  if (quantity == Quantity::time) return {"time_s", "time_ms", "time_min"};
  if (quantity == Quantity::volume) return {"volume_ml", "volume_L"};
  return {"flow_L_s", "flow_L_min", "flow_ml_s"};
}

}  // namespace

void ColumnName::set(const Unit& known) {
  unit = known.name;
  quantity = known.quantity;
  to_si = known.to_si;
}

std::optional<Unit> unit_of(std::string_view text) {
  const std::string plain = "_" + without_conditions(plain_name(text));
  for (const UnitSpelling& spelling : unit_spellings())
    if (plain == spelling.suffix) return spelling.unit;
  return std::nullopt;
}

ColumnName column_name(std::string_view header) {
  ColumnName column{std::string(header), plain_name(header), {}, {}, Quantity::unknown, 1};
  column.base = column.plain;
  const std::string plain = without_conditions(column.plain);
  if (const auto unit = unit_of(header))
    column.set(*unit);
  else if (const auto brackets = unit_in_brackets(header)) {
    column.base = plain_name(brackets->rest);
    column.set(brackets->unit);
  } else if (const UnitSpelling* spelling = ending_of(plain)) {
    column.base = plain.substr(0, plain.size() - spelling->suffix.size());
    column.set(spelling->unit);
  }
  return column;
}

bool is_documented(const ColumnName& column) {
  const std::string& base = column.base;
  return (column.quantity == Quantity::time && (base == "time" || base == "t")) ||
         (column.quantity == Quantity::flow && base == "flow") ||
         (column.quantity == Quantity::volume && base == "volume");
}

std::optional<Role> role_of(const ColumnName& column) {
  std::optional<Role> role;
  if (unit_of(column.base)) {  // the unit replaces the name
    if (column.quantity == Quantity::time) return Role::time;
    if (column.quantity == Quantity::flow) return Role::flow;
    if (column.quantity == Quantity::volume) return Role::volume;
    return std::nullopt;
  }
  const auto words = column_words();
  for (const std::string_view part : parts_of(column.base)) {
    const auto word =
        std::find_if(words.begin(), words.end(), [&](const ColumnWord& known) { return known.text == part; });
    const bool counts = word != words.end() && (!role || *role == Role::belt || word->role != Role::belt);
    if (counts && role && *role != Role::belt && *role != word->role)
      return std::nullopt;  // "volume_from_flow"
    if (counts) role = word->role;
    if (word == words.end() && !is_ignored(part)) return std::nullopt;
  }
  return role;
}

std::string suggestion(const std::vector<ColumnName>& columns, Quantity quantity) {
  const auto names = expected_names(quantity);
  const ColumnName first = column_name(names.front());
  const std::string unit_option = quantity == Quantity::time     ? "--time-unit s"
                                  : quantity == Quantity::volume ? "--unit ml"
                                                                 : "--unit L/s";
  for (const auto& column : columns)
    if (column.quantity == Quantity::unknown && role_of(column) == role_of(first))
      return fmt::format("{} has no unit: name it {} or {}, or add an option like {}", excerpt(column.text),
                         names.front(), names[1], unit_option);
  for (const auto& column : columns)
    if (column.plain.starts_with(first.base) && column.quantity == Quantity::unknown)
      return fmt::format("the unit of {} is not known: convert it to {}", excerpt(column.text),
                         names.front());
  for (const auto& column : columns)
    for (const auto& name : names)
      if (edit_distance(column.plain, column_name(name).plain) <= 2)
        return fmt::format("if {} is meant, name it {}", excerpt(column.text), name);
  for (const auto& column : columns)
    if (column.quantity == quantity)
      return fmt::format("if {0} is meant, add --{1} {0}", excerpt(column.text), first.base);
  return "";
}

std::string list_of(const std::vector<ColumnName>& columns) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(columns.size(), most); ++i)
    list += (i > 0 ? ", " : "") + excerpt(columns[i].text);
  return columns.size() > most ? fmt::format("{} and {} more", list, columns.size() - most) : list;
}

}  // namespace trunk
