#include "tables/column_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "text/edit_distance.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

struct Spelling {
  std::string_view suffix;
  Unit unit;
};

namespace units {
constexpr double litre = 1e-3, millilitre = 1e-6, minute = 60;
constexpr Unit ml_s{"ml_s", Quantity::flow, millilitre}, L_s{"L_s", Quantity::flow, litre},
    L_min{"L_min", Quantity::flow, litre / minute}, ml_min{"ml_min", Quantity::flow, millilitre / minute},
    m3_s{"m3_s", Quantity::flow, 1}, us{"us", Quantity::time, 1e-6}, ms{"ms", Quantity::time, 1e-3},
    s{"s", Quantity::time, 1}, min{"min", Quantity::time, minute}, h{"h", Quantity::time, 60 * minute},
    ml{"ml", Quantity::volume, millilitre}, cl{"cl", Quantity::volume, 10 * millilitre},
    dl{"dl", Quantity::volume, 100 * millilitre}, L{"L", Quantity::volume, litre},
    m3{"m3", Quantity::volume, 1};
}  // namespace units

// The longest that fits counts: "_l_min" and not "_min".
constexpr std::array spellings{Spelling{"_ml_s", units::ml_s},
                               Spelling{"_ml_sec", units::ml_s},
                               Spelling{"_ml_s_1", units::ml_s},
                               Spelling{"_cm3_s", units::ml_s},
                               Spelling{"_cm³_s", units::ml_s},
                               Spelling{"_cc_s", units::ml_s},
                               Spelling{"_l_s", units::L_s},
                               Spelling{"_l_sec", units::L_s},
                               Spelling{"_l_s_1", units::L_s},
                               Spelling{"_lps", units::L_s},
                               Spelling{"_litres_s", units::L_s},
                               Spelling{"_liters_s", units::L_s},
                               Spelling{"_l_min", units::L_min},
                               Spelling{"_l_mn", units::L_min},
                               Spelling{"_l_min_1", units::L_min},
                               Spelling{"_lpm", units::L_min},
                               Spelling{"_litres_min", units::L_min},
                               Spelling{"_liters_min", units::L_min},
                               Spelling{"_ml_min", units::ml_min},
                               Spelling{"_ml_mn", units::ml_min},
                               Spelling{"_m3_s", units::m3_s},
                               Spelling{"_m³_s", units::m3_s},
                               Spelling{"_us", units::us},
                               Spelling{"_µs", units::us},
                               Spelling{"_μs", units::us},
                               Spelling{"_microseconds", units::us},
                               Spelling{"_ms", units::ms},
                               Spelling{"_msec", units::ms},
                               Spelling{"_milliseconds", units::ms},
                               Spelling{"_millisekunden", units::ms},
                               Spelling{"_s", units::s},
                               Spelling{"_sec", units::s},
                               Spelling{"_sek", units::s},
                               Spelling{"_secs", units::s},
                               Spelling{"_seconds", units::s},
                               Spelling{"_sekunden", units::s},
                               Spelling{"_secondes", units::s},
                               Spelling{"_segundos", units::s},
                               Spelling{"_secondi", units::s},
                               Spelling{"_min", units::min},
                               Spelling{"_minutes", units::min},
                               Spelling{"_minuten", units::min},
                               Spelling{"_mn", units::min},
                               Spelling{"_h", units::h},
                               Spelling{"_hours", units::h},
                               Spelling{"_stunden", units::h},
                               Spelling{"_ml", units::ml},
                               Spelling{"_millilitres", units::ml},
                               Spelling{"_milliliters", units::ml},
                               Spelling{"_milliliter", units::ml},
                               Spelling{"_cm3", units::ml},
                               Spelling{"_cm³", units::ml},
                               Spelling{"_ccm", units::ml},
                               Spelling{"_cc", units::ml},
                               Spelling{"_cl", units::cl},
                               Spelling{"_dl", units::dl},
                               Spelling{"_l", units::L},
                               Spelling{"_litres", units::L},
                               Spelling{"_liters", units::L},
                               Spelling{"_litre", units::L},
                               Spelling{"_liter", units::L},
                               Spelling{"_litros", units::L},
                               Spelling{"_litri", units::L},
                               Spelling{"_m3", units::m3},
                               Spelling{"_m³", units::m3}};

// Gas conditions behind a unit, as spirometers write them.
constexpr std::array gas_conditions{"_btps", "_atps", "_atpd", "_stpd"};

struct Word {
  std::string_view text;
  Role role;
};

constexpr std::array column_words{Word{"time", Role::time},          Word{"t", Role::time},
                                  Word{"timestamp", Role::time},     Word{"elapsed", Role::time},
                                  Word{"datetime", Role::time},      Word{"zeit", Role::time},
                                  Word{"uhrzeit", Role::time},       Word{"zeitstempel", Role::time},
                                  Word{"temps", Role::time},         Word{"heure", Role::time},
                                  Word{"tiempo", Role::time},        Word{"tempo", Role::time},
                                  Word{"hora", Role::time},          Word{"ora", Role::time},
                                  Word{"tijd", Role::time},          Word{"tid", Role::time},
                                  Word{"flow", Role::flow},          Word{"airflow", Role::flow},
                                  Word{"fluss", Role::flow},         Word{"fluß", Role::flow},
                                  Word{"atemfluss", Role::flow},     Word{"atemstrom", Role::flow},
                                  Word{"atemfluß", Role::flow},      Word{"luftstrom", Role::flow},
                                  Word{"debit", Role::flow},         Word{"débit", Role::flow},
                                  Word{"flujo", Role::flow},         Word{"flusso", Role::flow},
                                  Word{"fluxo", Role::flow},         Word{"luchtstroom", Role::flow},
                                  Word{"flöde", Role::flow},         Word{"luftflöde", Role::flow},
                                  Word{"pneumotach", Role::flow},    Word{"volume", Role::volume},
                                  Word{"vol", Role::volume},         Word{"volumen", Role::volume},
                                  Word{"atemvolumen", Role::volume}, Word{"lungenvolumen", Role::volume},
                                  Word{"volym", Role::volume},       Word{"belt", Role::belt},
                                  Word{"resp", Role::belt},          Word{"respiration", Role::belt},
                                  Word{"breathing", Role::belt},     Word{"atmung", Role::belt},
                                  Word{"atemgurt", Role::belt},      Word{"gurt", Role::belt},
                                  Word{"thorax", Role::belt},        Word{"thor", Role::belt},
                                  Word{"chest", Role::belt},         Word{"abdomen", Role::belt},
                                  Word{"abdo", Role::belt},          Word{"rip", Role::belt},
                                  Word{"respiracion", Role::belt},   Word{"respiración", Role::belt}};

// They do not change what a column is. Those of the respiratory tract are belts where they stand alone.
constexpr std::array<std::string_view, 34> passed_over{
    "resp",  "respiratory", "breathing", "air",      "airway",    "mouth", "nasal",   "oral", "lung",
    "lungs", "mask",        "signal",    "sensor",   "channel",   "ch",    "kanal",   "raw",  "filtered",
    "belt",  "effort",      "chest",     "thoracic", "abdominal", "au",    "a",       "u",    "stamp",
    "date",  "and",         "since",     "start",    "elapsed",   "rel",   "relative"};

// Everything but ASCII letters, digits and the bytes of other scripts separates words. Capitals of western
// Europe (U+00C0 to U+00DE) are made small as ASCII ones are.
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
  for (const std::string_view condition : gas_conditions)
    if (plain.ends_with(condition)) plain.resize(plain.size() - condition.size());
  return plain;
}

const Spelling* ending_of(std::string_view plain) {
  const Spelling* longest = nullptr;
  for (const Spelling& spelling : spellings)
    if (plain.ends_with(spelling.suffix) && (!longest || spelling.suffix.size() > longest->suffix.size()))
      longest = &spelling;
  return longest;
}

struct Brackets {
  Unit unit;
  std::string rest;
};

// "Flow [L/s] at the mouth" => L_s, "Flow  at the mouth".
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

bool is_passed_over(std::string_view part) {
  return std::find(passed_over.begin(), passed_over.end(), part) != passed_over.end() ||
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
  for (const Spelling& spelling : spellings)
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
  } else if (const Spelling* spelling = ending_of(plain)) {
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
  if (unit_of(column.base))  // a unit stands for the name
    return column.quantity == Quantity::time   ? Role::time
           : column.quantity == Quantity::flow ? Role::flow
                                               : Role::volume;
  for (const std::string_view part : parts_of(column.base)) {
    const auto word =
        std::find_if(column_words.begin(), column_words.end(), [&](const Word& w) { return w.text == part; });
    const bool counts =
        word != column_words.end() && (!role || *role == Role::belt || word->role != Role::belt);
    if (counts && role && *role != Role::belt && *role != word->role)
      return std::nullopt;  // "volume_from_flow"
    if (counts) role = word->role;
    if (word == column_words.end() && !is_passed_over(part)) return std::nullopt;
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
      return excerpt(column.text) + " has no unit: name it " + names.front() + " or " + names[1] +
             ", or add one like " + unit_option;
  for (const auto& column : columns)
    if (column.plain.starts_with(first.base) && column.quantity == Quantity::unknown)
      return "the unit of " + excerpt(column.text) + " is not known: convert it to " + names.front();
  for (const auto& column : columns)
    for (const auto& name : names)
      if (edit_distance(column.plain, column_name(name).plain) <= 2)
        return "if " + excerpt(column.text) + " is meant, name it " + name;
  for (const auto& column : columns)
    if (column.quantity == quantity)
      return "if " + excerpt(column.text) + " is meant, add --" + first.base + " " + excerpt(column.text);
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
