#include <algorithm>

#include "report/contents.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;

constexpr std::size_t most_columns = 200, most_samples = 500'000, most_text = 300;

/// Returns the beginning of each text: a table cell shows no more.
Json text_column(const std::vector<std::string>& texts) {
  if (texts.empty()) return nullptr;
  Json list = Json::array();
  for (const std::string& text : texts) list.push_back(text.substr(0, most_text));
  return list;
}

/// Returns ΔV of all runs, thinned to `most_samples`.
Json curve_table(const StoredSweep& sweep, Packed& packed) {
  const std::size_t rows = sweep.status.size(), samples = sweep.curve_time_s.size();
  if (samples == 0 || rows == 0) return nullptr;
  const std::size_t every = std::max<std::size_t>(1, (rows * samples + most_samples - 1) / most_samples);
  std::vector<double> moments, volumes;
  for (std::size_t i = 0; i < samples; i += every) moments.push_back(sweep.curve_time_s[i]);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t i = 0; i < samples; i += every) volumes.push_back(sweep.curve_dV_ml[row * samples + i]);
  return {{"every", every},
          {"samples", moments.size()},
          {"time", packed.add(moments)},
          {"values", packed.add_single(volumes)}};
}

}  // namespace

Json sweep_contents(const StoredSweep& sweep, Packed& packed) {
  Json json{{"runs", sweep.runs},
            {"rows", sweep.status.size()},
            {"sweep_toml", sweep.sweep_toml},
            {"scenario", text_column(sweep.scenario)},
            {"status", text_column(sweep.status)},
            {"subject", text_column(sweep.subject)},
            {"error", text_column(sweep.error)},
            {"columns", Json::array()}};
  for (const NamedColumn& column : sweep.columns) {
    if (json["columns"].size() == most_columns) break;
    json["columns"].push_back(
        {{"name", column.name}, {"unit", column.unit}, {"values", json_list(column.values)}});
  }
  json["curves"] = curve_table(sweep, packed);
  return json;
}

}  // namespace trunk
