#include "commands/text/breath_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "commands/text/clinic_table.hpp"
#include "math/median.hpp"
#include "math/units.hpp"
#include "subject/clinic_json.hpp"
#include "subject/window_json.hpp"

namespace trunk {
namespace {

/// The units in which the volumes of a trace are shown.
struct ShownUnits {
  bool calibrated;
  double volume(double m3) const { return calibrated ? ml_per_m3 * m3 : m3; }
  double ventilation(double m3_s) const { return calibrated ? 60e3 * m3_s : 60 * m3_s; }
  std::string volume_key(const std::string& name) const { return name + (calibrated ? "_ml" : "_au"); }
  std::string ventilation_key() const {
    return calibrated ? "minute_ventilation_L_min" : "minute_ventilation_au_min";
  }
};

struct BreathMeasure {
  std::string name;
  double value;
};

/// Returns the measures of a breath, always in the same order.
std::vector<BreathMeasure> measures_of(const Breath& b, const ShownUnits& units) {
  return {{"inspiration_s", b.inspiration_s()},
          {"expiration_s", b.expiration_s()},
          {"duration_s", b.duration_s()},
          {"pause_s", b.pause_s},
          {units.volume_key("tidal_volume"), units.volume(b.tidal_volume_m3)},
          {units.volume_key("inspired"), units.volume(b.inspired_m3)},
          {units.volume_key("expired"), units.volume(b.expired_m3)},
          {units.ventilation_key(), units.ventilation(b.ventilation_m3_s())}};
}

std::vector<Breath> kept_of(const Segmentation& s) {
  std::vector<Breath> kept;
  std::copy_if(s.breaths.begin(), s.breaths.end(), std::back_inserter(kept),
               [](const Breath& b) { return b.kept; });
  return kept;
}

/// Returns the median of each measure over some breaths (at least one).
std::vector<BreathMeasure> medians_of(const std::vector<Breath>& breaths, const ShownUnits& units) {
  std::vector<BreathMeasure> medians = measures_of(breaths.front(), units);
  for (std::size_t column = 0; column < medians.size(); ++column) {
    std::vector<double> values;
    for (const Breath& b : breaths) values.push_back(measures_of(b, units)[column].value);
    medians[column].value = median(std::move(values));
  }
  return medians;
}

struct BreathTotals {
  double duration_s = 0, volume_m3 = 0, inspiration_s = 0;
};

BreathTotals totals_of(const std::vector<Breath>& breaths) {
  BreathTotals total;
  for (const Breath& b : breaths) {
    total.duration_s += b.duration_s();
    total.volume_m3 += b.tidal_volume_m3;
    total.inspiration_s += b.inspiration_s();
  }
  return total;
}

Json as_object(const std::vector<BreathMeasure>& columns) {
  Json object = Json::object();
  for (const BreathMeasure& c : columns) object[c.name] = json_number(c.value);
  return object;
}

std::string table_row(const std::string& head, const std::vector<BreathMeasure>& m, const std::string& end) {
  return fmt::format("{} {:>6.2f} {:>6.2f} {:>6.2f} {:>6.2f} {:>8.4g} {:>8.3g}  {}\n", head, m[0].value,
                     m[1].value, m[2].value, m[3].value, m[4].value, m[7].value, end);
}

std::string judgement(const Breath& b) {
  return (b.kept ? "yes" : "no") + (b.reason.empty() ? "" : ": " + b.reason);
}

std::string csv_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

Json breaths_json(const Segmentation& s, const std::vector<ClinicNumber>& clinic) {
  const ShownUnits units{s.calibrated};
  const std::vector<Breath> kept = kept_of(s);
  Json json{{"schema", "trunk.breaths/1"},
            {"breaths_found", s.breaths.size()},
            {"breaths_kept", kept.size()},
            {"calibrated", s.calibrated}};
  if (!kept.empty()) {
    const BreathTotals total = totals_of(kept);
    const auto n = static_cast<double>(kept.size());
    json[units.volume_key("tidal_volume")] = units.volume(total.volume_m3 / n);
    json["inspiration_s"] = total.inspiration_s / n;
    json["duration_s"] = total.duration_s / n;
    json["total_s"] = total.duration_s;
    json["breaths_per_min"] = 60 * n / total.duration_s;
    json[units.ventilation_key()] = units.ventilation(total.volume_m3 / total.duration_s);
    json["median"] = as_object(medians_of(kept, units));
  }
  if (s.window) json["window"] = window_json(*s.window);
  if (!s.channels.empty() || s.excursion_m) json["channels"] = channels_json(s);
  if (!clinic.empty()) json["clinic"] = clinic_json(clinic);
  Json list = Json::array();
  std::size_t used = 0;
  for (const Breath& b : s.breaths) {
    Json one{{"number", b.number}, {"onset_s", b.onset_s}, {"peak_s", b.peak_s}, {"end_s", b.end_s}};
    one.update(as_object(measures_of(b, units)));
    one["kept"] = b.kept;
    one["reason"] = b.reason;
    if (b.kept) one.update(clinic_json_of(clinic, used++));
    list.push_back(one);
  }
  json["breaths"] = list;
  json["notes"] = s.notes;
  return json;
}

std::string breaths_text(const Segmentation& s, const std::vector<ClinicNumber>& clinic) {
  const ShownUnits units{s.calibrated};
  std::string text = fmt::format(
      "  breath  onset s   peak s    end s   Ti s   Te s Ttot s  pause  VT {:>5} V' {:>5}  kept\n",
      s.calibrated ? "ml" : "a.u.", s.calibrated ? "L/min" : "/min");
  for (const Breath& b : s.breaths)
    text +=
        table_row(fmt::format("  {:>6} {:>8.2f} {:>8.2f} {:>8.2f}", b.number, b.onset_s, b.peak_s, b.end_s),
                  measures_of(b, units), judgement(b));
  const std::vector<Breath> kept = kept_of(s);
  if (!kept.empty()) {
    text += table_row(fmt::format("  {:<33}", "median of those kept"), medians_of(kept, units), "");
    const BreathTotals total = totals_of(kept);
    const auto n = static_cast<double>(kept.size());
    text += fmt::format("{} breaths found, {} kept: {:.4g} s, {:.3g} breaths/min, {:.3g} {}/min",
                        s.breaths.size(), kept.size(), total.duration_s, 60 * n / total.duration_s,
                        units.ventilation(total.volume_m3 / total.duration_s), s.calibrated ? "L" : "a.u.");
  } else {
    text += fmt::format("{} breaths found, none kept", s.breaths.size());
  }
  if (!clinic.empty()) text += "\n" + clinic_table(clinic, kept), text.pop_back();
  if (!s.calibrated)
    text += "\nThe volumes are in the belt's own unit: --calibrate-tidal-volume ML makes them ml.";
  return text;
}

std::string breaths_csv(const Segmentation& s, const std::vector<ClinicNumber>& clinic) {
  const ShownUnits units{s.calibrated};
  std::string text = "number,onset_s,peak_s,end_s";
  for (const BreathMeasure& c : measures_of(s.breaths.front(), units)) text += "," + c.name;
  for (const ClinicNumber& n : clinic) text += "," + n.name;
  text += ",kept,reason\n";
  std::size_t used = 0;
  for (const Breath& b : s.breaths) {
    text += fmt::format("{},{:.6g},{:.6g},{:.6g}", b.number, b.onset_s, b.peak_s, b.end_s);
    for (const BreathMeasure& c : measures_of(b, units)) text += fmt::format(",{:.6g}", c.value);
    for (const ClinicNumber& n : clinic)
      text += b.kept && std::isfinite(n.each[used]) ? fmt::format(",{:.6g}", n.each[used]) : ",";
    used += b.kept ? 1 : 0;
    text += fmt::format(",{},{}\n", b.kept ? 1 : 0, csv_quoted(b.reason));
  }
  return text;
}

Json curve_json(const Segmentation& s) {
  constexpr double longest_step_s = 0.02;
  const ShownUnits units{s.calibrated};
  Json time = Json::array(), volume = Json::array();
  double next = s.time_s.front();
  for (std::size_t i = 0; i < s.time_s.size(); ++i) {
    if (s.time_s[i] < next) continue;
    next = s.time_s[i] + longest_step_s * (1 - 1e-9);
    time.push_back(s.time_s[i]);
    volume.push_back(json_number(units.volume(s.volume_m3[i])));
  }
  return {{"time_s", time}, {units.volume_key("volume"), volume}};
}

}  // namespace trunk
