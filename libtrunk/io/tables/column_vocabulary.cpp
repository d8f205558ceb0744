#include "tables/column_vocabulary.hpp"

#include <array>

#include "math/units.hpp"

namespace trunk {
namespace {

namespace units {
constexpr double litre = m3_per_litre, millilitre = m3_per_ml, minute = s_per_min;
constexpr Unit ml_s{"ml_s", Quantity::flow, millilitre}, L_s{"L_s", Quantity::flow, litre},
    L_min{"L_min", Quantity::flow, litre / minute}, ml_min{"ml_min", Quantity::flow, millilitre / minute},
    m3_s{"m3_s", Quantity::flow, 1}, us{"us", Quantity::time, 1e-6}, ms{"ms", Quantity::time, s_per_ms},
    s{"s", Quantity::time, 1}, min{"min", Quantity::time, minute}, h{"h", Quantity::time, 60 * minute},
    ml{"ml", Quantity::volume, millilitre}, cl{"cl", Quantity::volume, 10 * millilitre},
    dl{"dl", Quantity::volume, 100 * millilitre}, L{"L", Quantity::volume, litre},
    m3{"m3", Quantity::volume, 1}, cmH2O{"cmH2O", Quantity::pressure, Pa_per_cmH2O},
    mbar{"mbar", Quantity::pressure, 100}, hPa{"hPa", Quantity::pressure, 100},
    kPa{"kPa", Quantity::pressure, 1000}, Pa{"Pa", Quantity::pressure, 1},
    mmHg{"mmHg", Quantity::pressure, Pa_per_mmHg}, mm{"mm", Quantity::length, m_per_mm},
    cm{"cm", Quantity::length, 1e-2};
}  // namespace units

constexpr std::array all_spellings{UnitSpelling{"_ml_s", units::ml_s},
                                   UnitSpelling{"_ml_sec", units::ml_s},
                                   UnitSpelling{"_ml_s_1", units::ml_s},
                                   UnitSpelling{"_cm3_s", units::ml_s},
                                   UnitSpelling{"_cm³_s", units::ml_s},
                                   UnitSpelling{"_cc_s", units::ml_s},
                                   UnitSpelling{"_l_s", units::L_s},
                                   UnitSpelling{"_l_sec", units::L_s},
                                   UnitSpelling{"_l_s_1", units::L_s},
                                   UnitSpelling{"_lps", units::L_s},
                                   UnitSpelling{"_litres_s", units::L_s},
                                   UnitSpelling{"_liters_s", units::L_s},
                                   UnitSpelling{"_l_min", units::L_min},
                                   UnitSpelling{"_l_mn", units::L_min},
                                   UnitSpelling{"_l_min_1", units::L_min},
                                   UnitSpelling{"_lpm", units::L_min},
                                   UnitSpelling{"_litres_min", units::L_min},
                                   UnitSpelling{"_liters_min", units::L_min},
                                   UnitSpelling{"_ml_min", units::ml_min},
                                   UnitSpelling{"_ml_mn", units::ml_min},
                                   UnitSpelling{"_m3_s", units::m3_s},
                                   UnitSpelling{"_m³_s", units::m3_s},
                                   UnitSpelling{"_us", units::us},
                                   UnitSpelling{"_µs", units::us},
                                   UnitSpelling{"_μs", units::us},
                                   UnitSpelling{"_microseconds", units::us},
                                   UnitSpelling{"_ms", units::ms},
                                   UnitSpelling{"_msec", units::ms},
                                   UnitSpelling{"_milliseconds", units::ms},
                                   UnitSpelling{"_millisekunden", units::ms},
                                   UnitSpelling{"_s", units::s},
                                   UnitSpelling{"_sec", units::s},
                                   UnitSpelling{"_sek", units::s},
                                   UnitSpelling{"_secs", units::s},
                                   UnitSpelling{"_seconds", units::s},
                                   UnitSpelling{"_sekunden", units::s},
                                   UnitSpelling{"_secondes", units::s},
                                   UnitSpelling{"_segundos", units::s},
                                   UnitSpelling{"_secondi", units::s},
                                   UnitSpelling{"_min", units::min},
                                   UnitSpelling{"_minutes", units::min},
                                   UnitSpelling{"_minuten", units::min},
                                   UnitSpelling{"_mn", units::min},
                                   UnitSpelling{"_h", units::h},
                                   UnitSpelling{"_hours", units::h},
                                   UnitSpelling{"_stunden", units::h},
                                   UnitSpelling{"_ml", units::ml},
                                   UnitSpelling{"_millilitres", units::ml},
                                   UnitSpelling{"_milliliters", units::ml},
                                   UnitSpelling{"_milliliter", units::ml},
                                   UnitSpelling{"_cm3", units::ml},
                                   UnitSpelling{"_cm³", units::ml},
                                   UnitSpelling{"_ccm", units::ml},
                                   UnitSpelling{"_cc", units::ml},
                                   UnitSpelling{"_cl", units::cl},
                                   UnitSpelling{"_dl", units::dl},
                                   UnitSpelling{"_l", units::L},
                                   UnitSpelling{"_litres", units::L},
                                   UnitSpelling{"_liters", units::L},
                                   UnitSpelling{"_litre", units::L},
                                   UnitSpelling{"_liter", units::L},
                                   UnitSpelling{"_litros", units::L},
                                   UnitSpelling{"_litri", units::L},
                                   UnitSpelling{"_m3", units::m3},
                                   UnitSpelling{"_m³", units::m3},
                                   UnitSpelling{"_cmh2o", units::cmH2O},
                                   UnitSpelling{"_cm_h2o", units::cmH2O},
                                   UnitSpelling{"_cmh₂o", units::cmH2O},
                                   UnitSpelling{"_cm_h₂o", units::cmH2O},
                                   UnitSpelling{"_mbar", units::mbar},
                                   UnitSpelling{"_hpa", units::hPa},
                                   UnitSpelling{"_kpa", units::kPa},
                                   UnitSpelling{"_pa", units::Pa},
                                   UnitSpelling{"_mmhg", units::mmHg},
                                   UnitSpelling{"_mm_hg", units::mmHg},
                                   UnitSpelling{"_torr", units::mmHg},
                                   UnitSpelling{"_mm", units::mm},
                                   UnitSpelling{"_cm", units::cm}};

constexpr std::array<std::string_view, 4> all_conditions{"_btps", "_atps", "_atpd", "_stpd"};

constexpr std::array all_words{
    ColumnWord{"time", Role::time},          ColumnWord{"t", Role::time},
    ColumnWord{"timestamp", Role::time},     ColumnWord{"elapsed", Role::time},
    ColumnWord{"datetime", Role::time},      ColumnWord{"zeit", Role::time},
    ColumnWord{"uhrzeit", Role::time},       ColumnWord{"zeitstempel", Role::time},
    ColumnWord{"temps", Role::time},         ColumnWord{"heure", Role::time},
    ColumnWord{"tiempo", Role::time},        ColumnWord{"tempo", Role::time},
    ColumnWord{"hora", Role::time},          ColumnWord{"ora", Role::time},
    ColumnWord{"tijd", Role::time},          ColumnWord{"tid", Role::time},
    ColumnWord{"flow", Role::flow},          ColumnWord{"airflow", Role::flow},
    ColumnWord{"fluss", Role::flow},         ColumnWord{"fluß", Role::flow},
    ColumnWord{"atemfluss", Role::flow},     ColumnWord{"atemstrom", Role::flow},
    ColumnWord{"atemfluß", Role::flow},      ColumnWord{"luftstrom", Role::flow},
    ColumnWord{"debit", Role::flow},         ColumnWord{"débit", Role::flow},
    ColumnWord{"flujo", Role::flow},         ColumnWord{"flusso", Role::flow},
    ColumnWord{"fluxo", Role::flow},         ColumnWord{"luchtstroom", Role::flow},
    ColumnWord{"flöde", Role::flow},         ColumnWord{"luftflöde", Role::flow},
    ColumnWord{"pneumotach", Role::flow},    ColumnWord{"volume", Role::volume},
    ColumnWord{"vol", Role::volume},         ColumnWord{"volumen", Role::volume},
    ColumnWord{"atemvolumen", Role::volume}, ColumnWord{"lungenvolumen", Role::volume},
    ColumnWord{"volym", Role::volume},       ColumnWord{"belt", Role::belt},
    ColumnWord{"resp", Role::belt},          ColumnWord{"respiration", Role::belt},
    ColumnWord{"breathing", Role::belt},     ColumnWord{"atmung", Role::belt},
    ColumnWord{"atemgurt", Role::belt},      ColumnWord{"gurt", Role::belt},
    ColumnWord{"thorax", Role::belt},        ColumnWord{"thor", Role::belt},
    ColumnWord{"chest", Role::belt},         ColumnWord{"abdomen", Role::belt},
    ColumnWord{"abdo", Role::belt},          ColumnWord{"rip", Role::belt},
    ColumnWord{"respiracion", Role::belt},   ColumnWord{"respiración", Role::belt}};

constexpr std::array<std::string_view, 34> all_ignored{
    "resp",  "respiratory", "breathing", "air",      "airway",    "mouth", "nasal",   "oral", "lung",
    "lungs", "mask",        "signal",    "sensor",   "channel",   "ch",    "kanal",   "raw",  "filtered",
    "belt",  "effort",      "chest",     "thoracic", "abdominal", "au",    "a",       "u",    "stamp",
    "date",  "and",         "since",     "start",    "elapsed",   "rel",   "relative"};

}  // namespace

std::span<const UnitSpelling> unit_spellings() {
  return all_spellings;
}

std::span<const std::string_view> gas_conditions() {
  return all_conditions;
}

std::span<const ColumnWord> column_words() {
  return all_words;
}

std::span<const std::string_view> ignored_words() {
  return all_ignored;
}

}  // namespace trunk
