#include <algorithm>

#include "report/contents.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;

constexpr std::size_t most_rows = 5000, most_columns = 200, most_samples = 500'000, most_text = 300;

/// A few hundred bytes of each say enough in a table.
Json text_column(const std::vector<std::string>& texts, std::size_t rows) {
  if (texts.empty()) return nullptr;
  Json list = Json::array();
  for (std::size_t i = 0; i < rows; ++i) list.push_back(texts[i].substr(0, most_text));
  return list;
}

/// ΔV of the rows shown, every so many samples.
Json curve_table(const SweepRecord& sweep, std::size_t rows, Packed& packed) {
  const std::size_t samples = sweep.curve_time_s.size();
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

Json sweep_contents(const SweepRecord& sweep, Packed& packed) {
  const std::size_t runs = sweep.status.size(), rows = std::min(runs, most_rows);
  Json json{{"runs", runs},
            {"rows", rows},
            {"sweep_toml", sweep.sweep_toml},
            {"scenario", text_column(sweep.scenario, rows)},
            {"status", text_column(sweep.status, rows)},
            {"error", text_column(sweep.error, rows)},
            {"columns", Json::array()}};
  for (const NamedColumn& column : sweep.columns) {
    if (json["columns"].size() == most_columns) break;
    const std::vector<double> shown(column.values.begin(),
                                    column.values.begin() + static_cast<std::ptrdiff_t>(rows));
    json["columns"].push_back({{"name", column.name}, {"unit", column.unit}, {"values", json_list(shown)}});
  }
  json["curves"] = curve_table(sweep, rows, packed);
  return json;
}

}  // namespace trunk
