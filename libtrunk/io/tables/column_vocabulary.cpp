#include "tables/column_vocabulary.hpp"

#include <array>

#include "math/units.hpp"

namespace trunk {
namespace {

namespace units {
// What a spelling stands for.
struct Meaning {
  std::string_view name;
  Quantity quantity;
  double to_si;
};
constexpr double litre = m3_per_litre, millilitre = m3_per_ml, minute = s_per_min;
constexpr Meaning L_s{"L_s", Quantity::flow, litre}, L_min{"L_min", Quantity::flow, litre / minute},
    us{"us", Quantity::time, 1e-6}, ms{"ms", Quantity::time, s_per_ms}, s{"s", Quantity::time, 1},
    min{"min", Quantity::time, minute}, h{"h", Quantity::time, 60 * minute},
    ml{"ml", Quantity::volume, millilitre}, cl{"cl", Quantity::volume, 10 * millilitre},
    dl{"dl", Quantity::volume, 100 * millilitre}, L{"L", Quantity::volume, litre},
    m3{"m3", Quantity::volume, 1}, cmH2O{"cmH2O", Quantity::pressure, Pa_per_cmH2O},
    mbar{"mbar", Quantity::pressure, 100}, hPa{"hPa", Quantity::pressure, 100},
    kPa{"kPa", Quantity::pressure, 1000}, Pa{"Pa", Quantity::pressure, 1},
    mmHg{"mmHg", Quantity::pressure, Pa_per_mmHg}, mm{"mm", Quantity::length, m_per_mm},
    cm{"cm", Quantity::length, 1e-2};
}  // namespace units

constexpr UnitSpelling spelt(std::string_view suffix, const units::Meaning& unit) {
  return {suffix, unit.name, unit.quantity, unit.to_si};
}

constexpr std::array all_spellings{spelt("_lps", units::L_s),
                                   spelt("_lpm", units::L_min),
                                   spelt("_us", units::us),
                                   spelt("_µs", units::us),
                                   spelt("_μs", units::us),
                                   spelt("_microseconds", units::us),
                                   spelt("_ms", units::ms),
                                   spelt("_msec", units::ms),
                                   spelt("_milliseconds", units::ms),
                                   spelt("_millisekunden", units::ms),
                                   spelt("_s", units::s),
                                   spelt("_sec", units::s),
                                   spelt("_sek", units::s),
                                   spelt("_secs", units::s),
                                   spelt("_seconds", units::s),
                                   spelt("_sekunden", units::s),
                                   spelt("_secondes", units::s),
                                   spelt("_segundos", units::s),
                                   spelt("_secondi", units::s),
                                   spelt("_second", units::s),
                                   spelt("_sekunde", units::s),
                                   spelt("_min", units::min),
                                   spelt("_minutes", units::min),
                                   spelt("_minuten", units::min),
                                   spelt("_minute", units::min),
                                   spelt("_mn", units::min),
                                   spelt("_h", units::h),
                                   spelt("_hours", units::h),
                                   spelt("_hour", units::h),
                                   spelt("_hr", units::h),
                                   spelt("_stunden", units::h),
                                   spelt("_stunde", units::h),
                                   spelt("_ml", units::ml),
                                   spelt("_millilitres", units::ml),
                                   spelt("_milliliters", units::ml),
                                   spelt("_milliliter", units::ml),
                                   spelt("_millilitre", units::ml),
                                   spelt("_cm3", units::ml),
                                   spelt("_cm³", units::ml),
                                   spelt("_ccm", units::ml),
                                   spelt("_cc", units::ml),
                                   spelt("_cl", units::cl),
                                   spelt("_dl", units::dl),
                                   spelt("_l", units::L),
                                   spelt("_litres", units::L),
                                   spelt("_liters", units::L),
                                   spelt("_litre", units::L),
                                   spelt("_liter", units::L),
                                   spelt("_litros", units::L),
                                   spelt("_litri", units::L),
                                   spelt("_litro", units::L),
                                   spelt("_dm3", units::L),
                                   spelt("_dm³", units::L),
                                   spelt("_m3", units::m3),
                                   spelt("_m³", units::m3),
                                   spelt("_cmh2o", units::cmH2O),
                                   spelt("_cm_h2o", units::cmH2O),
                                   spelt("_cmh20", units::cmH2O),
                                   spelt("_cmh₂o", units::cmH2O),
                                   spelt("_cm_h₂o", units::cmH2O),
                                   spelt("_mbar", units::mbar),
                                   spelt("_hpa", units::hPa),
                                   spelt("_kpa", units::kPa),
                                   spelt("_pa", units::Pa),
                                   spelt("_mmhg", units::mmHg),
                                   spelt("_mm_hg", units::mmHg),
                                   spelt("_torr", units::mmHg),
                                   spelt("_mm", units::mm),
                                   spelt("_cm", units::cm)};

constexpr std::array<std::string_view, 4> all_conditions{"_btps", "_atps", "_atpd", "_stpd"};

constexpr std::array all_words{
    ColumnWord{"time", Role::time}, ColumnWord{"t", Role::time}, ColumnWord{"timestamp", Role::time},
    ColumnWord{"elapsed", Role::time}, ColumnWord{"datetime", Role::time}, ColumnWord{"zeit", Role::time},
    ColumnWord{"uhrzeit", Role::time}, ColumnWord{"zeitstempel", Role::time}, ColumnWord{"temps", Role::time},
    ColumnWord{"heure", Role::time}, ColumnWord{"tiempo", Role::time}, ColumnWord{"tempo", Role::time},
    ColumnWord{"hora", Role::time}, ColumnWord{"ora", Role::time}, ColumnWord{"tijd", Role::time},
    ColumnWord{"tid", Role::time}, ColumnWord{"flow", Role::flow}, ColumnWord{"airflow", Role::flow},
    ColumnWord{"fluss", Role::flow}, ColumnWord{"fluß", Role::flow}, ColumnWord{"atemfluss", Role::flow},
    ColumnWord{"atemstrom", Role::flow}, ColumnWord{"atemfluß", Role::flow},
    ColumnWord{"luftstrom", Role::flow}, ColumnWord{"debit", Role::flow}, ColumnWord{"débit", Role::flow},
    ColumnWord{"flujo", Role::flow}, ColumnWord{"flusso", Role::flow}, ColumnWord{"fluxo", Role::flow},
    ColumnWord{"luchtstroom", Role::flow}, ColumnWord{"flöde", Role::flow},
    ColumnWord{"luftflöde", Role::flow}, ColumnWord{"pneumotach", Role::flow},
    ColumnWord{"volume", Role::volume}, ColumnWord{"vol", Role::volume}, ColumnWord{"volumen", Role::volume},
    ColumnWord{"atemvolumen", Role::volume}, ColumnWord{"lungenvolumen", Role::volume},
    ColumnWord{"volym", Role::volume}, ColumnWord{"belt", Role::belt}, ColumnWord{"resp", Role::belt},
    ColumnWord{"respiration", Role::belt}, ColumnWord{"breathing", Role::belt},
    ColumnWord{"atmung", Role::belt}, ColumnWord{"atemgurt", Role::belt}, ColumnWord{"gurt", Role::belt},
    ColumnWord{"thorax", Role::belt}, ColumnWord{"thor", Role::belt}, ColumnWord{"chest", Role::belt},
    ColumnWord{"abdomen", Role::belt}, ColumnWord{"abdo", Role::belt}, ColumnWord{"rip", Role::belt},
    ColumnWord{"respiracion", Role::belt}, ColumnWord{"respiración", Role::belt},
    // In other languages, as ventilators are set to them.
    ColumnWord{"čas", Role::time}, ColumnWord{"cas", Role::time}, ColumnWord{"czas", Role::time},
    ColumnWord{"время", Role::time}, ColumnWord{"zaman", Role::time}, ColumnWord{"saat", Role::time},
    ColumnWord{"時間", Role::time}, ColumnWord{"時刻", Role::time}, ColumnWord{"时间", Role::time},
    ColumnWord{"aika", Role::time}, ColumnWord{"idő", Role::time}, ColumnWord{"χρόνος", Role::time},
    ColumnWord{"시간", Role::time}, ColumnWord{"timp", Role::time}, ColumnWord{"przepływ", Role::flow},
    ColumnWord{"przeplyw", Role::flow}, ColumnWord{"průtok", Role::flow}, ColumnWord{"prutok", Role::flow},
    ColumnWord{"prietok", Role::flow}, ColumnWord{"поток", Role::flow}, ColumnWord{"akış", Role::flow},
    ColumnWord{"akiş", Role::flow}, ColumnWord{"debi", Role::flow}, ColumnWord{"流量", Role::flow},
    ColumnWord{"流速", Role::flow}, ColumnWord{"気流", Role::flow}, ColumnWord{"virtaus", Role::flow},
    ColumnWord{"áramlás", Role::flow}, ColumnWord{"ροή", Role::flow}, ColumnWord{"ροη", Role::flow},
    ColumnWord{"유량", Role::flow}, ColumnWord{"기류", Role::flow}, ColumnWord{"luftstrøm", Role::flow},
    ColumnWord{"objętość", Role::volume}, ColumnWord{"objetosc", Role::volume},
    ColumnWord{"objem", Role::volume}, ColumnWord{"объем", Role::volume}, ColumnWord{"объём", Role::volume},
    ColumnWord{"hacim", Role::volume}, ColumnWord{"容量", Role::volume}, ColumnWord{"体积", Role::volume},
    ColumnWord{"容積", Role::volume}, ColumnWord{"換気量", Role::volume},
    ColumnWord{"tilavuus", Role::volume}, ColumnWord{"térfogat", Role::volume},
    ColumnWord{"όγκος", Role::volume}, ColumnWord{"용적", Role::volume}, ColumnWord{"abd", Role::belt},
    ColumnWord{"brustgurt", Role::belt}, ColumnWord{"bauchgurt", Role::belt},
    ColumnWord{"ribcage", Role::belt}, ColumnWord{"rc", Role::belt}, ColumnWord{"ab", Role::belt}};

constexpr std::array<std::string_view, 36> all_ignored{
    "at",   "rsp",      "resp",  "respiratory", "breathing", "air",      "airway",    "mouth", "nasal",
    "oral", "lung",     "lungs", "mask",        "signal",    "sensor",   "channel",   "ch",    "kanal",
    "raw",  "filtered", "belt",  "effort",      "chest",     "thoracic", "abdominal", "au",    "a",
    "u",    "stamp",    "date",  "and",         "since",     "start",    "elapsed",   "rel",   "relative"};

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
