#include "tables/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tables/column_vocabulary.hpp"
#include "text/edit_distance.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

struct Brackets {
  std::optional<Unit> unit;
  std::string rest, unclear;  // unclear: what looks like a unit
};

// Returns the unit that ends a text in words, "mouth, L/s" or "in s".
std::optional<Unit> unit_after_words(std::string_view text) {
  const auto at = text.find_last_of(" ,;:");
  if (at == std::string_view::npos) return std::nullopt;
  const std::string words = plain_name(text.substr(0, at));
  for (const std::string_view part :
       {"per", "pro", "par", "of", "milli", "micro", "centi", "deci", "kilo", "x"})
    if (words == part || words.ends_with("_" + std::string(part))) return std::nullopt;
  if (std::any_of(words.begin(), words.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  if (text.find_first_of("/*^%") < at) return std::nullopt;
  return unit_of(text.substr(at + 1));
}

// Returns L_s and "Flow  at the mouth" for "Flow [L/s] at the mouth".
Brackets unit_in_brackets(std::string_view header) {
  Brackets found;
  for (auto open = header.find_first_of("[("); open != std::string_view::npos;
       open = header.find_first_of("[(", open + 1)) {
    const auto close = header.find_first_of("])", open);
    if (close == std::string_view::npos) break;
    const std::string_view inside = header.substr(open + 1, close - open - 1);
    auto unit = unit_of(inside);
    if (!unit) unit = unit_after_words(inside);
    if (unit)
      return {unit, std::string(header.substr(0, open)) + " " + std::string(header.substr(close + 1)), ""};
    if (looks_like_unit(inside)) found.unclear = inside;
  }
  return found;
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

// "40ms" and "25hz" in a name are sampling rates; "tsd117" and "rsp100c" are sensors of BIOPAC.
bool is_rate_or_model(std::string_view part) {
  constexpr std::string_view digits = "0123456789";
  const std::string_view unit = part.substr(std::min(part.find_first_not_of(digits), part.size()));
  if (unit.size() < part.size()) return unit == "ms" || unit == "hz";
  for (const std::string_view model : {"tsd", "rsp", "da", "ss"}) {
    if (!part.starts_with(model)) continue;
    const std::string_view number = part.substr(model.size());
    const auto end = std::min(number.find_first_not_of(digits), number.size());
    return end >= 2 && number.size() <= end + 2;
  }
  return false;
}

bool is_ignored(std::string_view part) {
  const auto words = ignored_words();
  return std::find(words.begin(), words.end(), part) != words.end() ||
         part.find_first_not_of("0123456789") == std::string_view::npos || is_rate_or_model(part) ||
         (part.starts_with("ch") && part.find_first_not_of("0123456789", 2) == std::string_view::npos);
}

// Takes the longest unit at the end of a name: L_s of "flow_l_s".
void set_ending(ColumnName& column) {
  const std::string& plain = column.plain;
  for (auto at = plain.find('_'); at != std::string::npos; at = plain.find('_', at + 1))
    if (const auto unit = plain_unit(std::string_view(plain).substr(at + 1))) {
      column.base = plain.substr(0, at);
      return column.set(*unit);
    }
}

bool is_number(std::string_view part) {
  return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_word_of_factor(std::string_view part) {
  constexpr std::array<std::string_view, 20> words{
      "of",         "times", "tenths",  "hundredths",  "thousandths", "tenth", "hundredth",
      "thousandth", "milli", "micro",   "deci",        "centi",       "hecto", "hekto",
      "kilo",       "deca",  "zehntel", "hundertstel", "tausend",     "mal"};
  return std::find(words.begin(), words.end(), part) != words.end();
}

// Returns whether a sign of multiplication stands beside a digit: "0.1*Flow", "Flow ×10".
bool has_product(std::string_view text) {
  const auto is_digit_at = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (const std::string_view sign : {"*", "×", "÷"})
    for (auto at = text.find(sign); at != std::string_view::npos; at = text.find(sign, at + 1)) {
      const auto before = at > 0 ? text.find_last_not_of(' ', at - 1) : std::string_view::npos;
      const auto after = text.find_first_not_of(" .", at + sign.size());
      if (is_digit_at(before) || is_digit_at(after)) return true;
    }
  return false;
}

// Returns whether a name without its unit has what may be a factor: "flow_10", "flow_0_1", "flow_x10",
// "0_1_flow", "flow_in_tenths_of". A single digit is the number of a channel.
bool has_factor(std::string_view base) {
  const auto parts = parts_of(base);
  if (parts.empty()) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string_view part = parts[i], next = i + 1 < parts.size() ? parts[i + 1] : "";
    if (part.size() > 1 && part[0] == 'x' && is_number(part.substr(1))) return true;
    if ((part == "x" && is_number(next)) || (is_number(part) && next == "x")) return true;
  }
  if (parts.size() > 2 && parts[0] == "0" && is_number(parts[1])) return true;
  const std::string_view last = parts.back(), before = parts.size() > 1 ? parts[parts.size() - 2] : "";
  if (is_word_of_factor(last)) return true;
  return is_number(last) && (is_number(before) || last == "10" || last == "100" || last == "1000");
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
  unclear.clear();
}

std::string ColumnName::doubtful_unit() const {
  return unclear.empty() && quantity == Quantity::unknown && looks_like_unit(unit) ? unit : unclear;
}

ColumnName column_name(std::string_view header) {
  ColumnName column{std::string(header), plain_name(header), {}, {}, Quantity::unknown, 1, {}};
  column.base = column.plain;
  if (const auto unit = unit_of(header)) {
    column.set(*unit);
    return column;
  }
  const Brackets brackets = unit_in_brackets(header);
  if (brackets.unit) {
    column.base = plain_name(brackets.rest);
    column.set(*brackets.unit);
  } else if (brackets.unclear.empty()) {
    set_ending(column);
  }
  if (column.quantity != Quantity::unknown &&
      (has_factor(column.base) || has_product(brackets.unit ? brackets.rest : column.text)))
    column.unclear = header;
  if (!brackets.unit) column.unclear += brackets.unclear;
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

std::optional<TrunkPart> part_of_trunk(const ColumnName& belt) {
  const auto any_begins_with = [&](std::initializer_list<std::string_view> words) {
    for (const std::string_view part : parts_of(belt.base))
      for (const std::string_view word : words)
        if (part.starts_with(word)) return true;
    return false;
  };
  const bool thorax = belt.base == "rc" || any_begins_with({"thor", "chest", "brust", "rib"}),
             abdomen = belt.base == "ab" || any_begins_with({"abd", "bauch", "belly"});
  if (thorax == abdomen) return std::nullopt;
  return thorax ? TrunkPart::thorax : TrunkPart::abdomen;
}

std::string suggestion(const std::vector<ColumnName>& columns, Quantity quantity) {
  const auto names = expected_names(quantity);
  const ColumnName first = column_name(names.front());
  const std::string unit_option = quantity == Quantity::time     ? "--time-unit s"
                                  : quantity == Quantity::volume ? "--unit ml"
                                                                 : "--unit L/s";
  for (const auto& column : columns) {
    const std::string given = column.doubtful_unit();
    if (!given.empty() && ("_" + column.plain).find("_" + first.base) != std::string::npos)
      return fmt::format("the unit {} of {} is not known or not clear: {}", excerpt(given),
                         excerpt(column.text), how_to_give_a_unit(quantity));
  }
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

std::string how_to_give_a_unit(Quantity quantity) {
  const bool flow = quantity == Quantity::flow, time = quantity == Quantity::time;
  return fmt::format("write it as in ({}), with a factor before it as in ({}), or give it with --{}",
                     flow   ? "L/s"
                     : time ? "ms"
                            : "ml",
                     flow   ? "0.1 L/s"
                     : time ? "10 ms"
                            : "10 ml",
                     time ? "time-unit" : "unit");
}

std::string list_of(const std::vector<ColumnName>& columns) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(columns.size(), most); ++i)
    list += (i > 0 ? ", " : "") + excerpt(columns[i].text);
  return columns.size() > most ? fmt::format("{} and {} more", list, columns.size() - most) : list;
}

}  // namespace trunk
