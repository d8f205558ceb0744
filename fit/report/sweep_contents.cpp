#include <algorithm>

#include "report/contents.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;

constexpr std::size_t most_rows = 5000, most_columns = 200, most_samples = 500'000;

/// A name of 100 bytes says enough in a table.
Json texts(const StoredFile& file, const std::string& path, std::size_t rows) {
  Json list = Json::array();
  std::vector<std::string> all = file.texts(path);
  if (all.empty()) return nullptr;
  all.resize(rows);
  for (const std::string& text : all) list.push_back(text.substr(0, 300));
  return list;
}

/// ΔV of the rows shown, every so many samples.
Json curve_table(const StoredFile& file, std::size_t runs, std::size_t rows, Packed& packed) {
  const StoredArray time = file.array("curves/time"), curves = file.array("curves/dV");
  const std::size_t samples = time.values.size();
  if (samples == 0 || curves.values.empty()) return nullptr;
  of_size(runs * samples, curves, "curves/dV");
  const std::size_t every = std::max<std::size_t>(1, (rows * samples + most_samples - 1) / most_samples);
  std::vector<double> moments, volumes;
  for (std::size_t i = 0; i < samples; i += every) moments.push_back(time.values[i]);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t i = 0; i < samples; i += every) volumes.push_back(curves.values[row * samples + i]);
  return {{"every", every},
          {"samples", moments.size()},
          {"time", packed.add(moments)},
          {"unit", curves.unit},
          {"values", packed.add_single(volumes)}};
}

}  // namespace

Json sweep_contents(const StoredFile& file, Packed& packed) {
  const std::size_t runs = file.texts("table/status").size(), rows = std::min(runs, most_rows);
  Json sweep{{"runs", runs}, {"rows", rows}, {"sweep_toml", file.text("sweep_toml")}};
  for (const char* column : {"scenario", "status", "error"})
    sweep[column] = texts(file, std::string("table/") + column, rows);
  sweep["columns"] = Json::array();
  for (const std::string& name : file.datasets("table")) {
    if (name == "run" || sweep["columns"].size() == most_columns) continue;
    if (file.attribute("table/" + name, "units").empty()) continue;
    StoredArray column = file.array("table/" + name);
    of_size(runs, column, "table/" + name);
    column.values.resize(rows);
    sweep["columns"].push_back({{"name", name},
                                {"unit", column.unit},
                                {"meaning", column.meaning},
                                {"values", numbers(column.values)}});
  }
  sweep["curves"] = curve_table(file, runs, rows, packed);
  return sweep;
}

}  // namespace trunk
