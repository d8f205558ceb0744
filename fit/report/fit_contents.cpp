#include "report/contents.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;

Json measured_contents(const StoredFile& file, Packed& packed) {
  const StoredArray time = file.array("problem/time");
  if (time.values.empty()) return nullptr;
  const std::size_t size = time.values.size();
  const auto column = [&](const char* path) -> Json {
    const StoredArray values = file.array(path);
    return values.values.empty() ? Json(nullptr) : packed.add(of_size(size, values, path).values);
  };
  return {{"time", packed.add(time.values)},
          {"unit", file.attribute("problem/measured", "units")},
          {"measured", column("problem/measured")},
          {"sigma", column("problem/sigma")}};
}

/// Time and volumes of the fit; one-compartment's too where they are stored.
Json result_contents(const StoredFile& file, Packed& packed) {
  Json result{{"statistics", numbers_in(file, "result/statistics")}};
  for (const char* name : {"verdict", "stop_reason", "algorithm"})
    result[name] = file.attribute("result", name);
  const StoredArray time = file.array("result/time");
  if (time.values.empty()) return result;
  result["time"] = packed.add(time.values);
  for (const char* name : {"dV_fit", "residual", "dV_baseline"}) {
    const std::string path = std::string("result/") + name;
    if (file.has(path)) result[name] = packed.add(of_size(time.values.size(), file.array(path), path).values);
  }
  return result;
}

Json parameter_contents(const StoredFile& file) {
  const std::vector<std::string> names = file.texts("parameters/name"), units = file.texts("parameters/unit");
  Json table{{"name", names}, {"unit", units}};
  for (const char* column :
       {"initial", "lower", "upper", "best", "stderr", "lower95", "upper95", "at_bound", "free", "beside"}) {
    const std::string path = std::string("parameters/") + column;
    if (file.has(path)) table[column] = numbers(of_size(names.size(), file.array(path), path).values);
  }
  return table;
}

Json surface_contents(const StoredFile& file, Packed& packed) {
  if (!file.has("surface/deviance")) return nullptr;
  Json surface;
  std::size_t size = 1;
  for (const char* axis : {"first", "second"}) {
    const StoredArray values = file.array(std::string("surface/") + axis);
    surface[axis] = {{"name", values.meaning}, {"unit", values.unit}, {"values", numbers(values.values)}};
    size *= values.values.size();
  }
  const char* path = "surface/deviance";
  surface["deviance"] = packed.add(of_size(size, file.array(path), path).values);
  surface["threshold95"] = numbers(file.array("surface/threshold95").values);
  return surface;
}

Json profile_contents(const StoredFile& file) {
  Json profiles = Json::array();
  for (const std::string& name : file.groups("profiles")) {
    const std::string at = "profiles/" + name + "/";
    const StoredArray value = file.array(at + "value");
    Json profile{{"name", name}, {"unit", value.unit}, {"value", numbers(value.values)}};
    for (const char* column : {"deviance", "at_bound"})
      profile[column] = numbers(of_size(value.values.size(), file.array(at + column), at + column).values);
    for (const char* end : {"lower95", "upper95"}) profile[end] = numbers(file.array(at + end).values);
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

Json convergence_contents(const StoredFile& file, Packed& packed) {
  const StoredArray objective = file.array("evaluations/objective");
  if (objective.values.empty()) return nullptr;
  Json convergence{{"objective", packed.add(objective.values)},
                   {"parameter", file.texts("evaluations/parameter")},
                   {"unit", file.texts("evaluations/unit")}};
  const StoredArray x = file.array("evaluations/x");
  const std::size_t columns = convergence["parameter"].size();
  convergence["x"] = packed.add(of_size(objective.values.size() * columns, x, "evaluations/x").values);
  return convergence;
}

Json breath_contents(const StoredFile& file) {
  const std::vector<std::string> status = file.texts("breaths/status");
  if (status.empty()) return nullptr;
  Json breaths{{"status", status}, {"columns", Json::array()}};
  for (const std::string& name : file.datasets("breaths")) {
    const StoredArray column = file.array("breaths/" + name);
    if (name == "fitted_breath" || column.unit.empty()) continue;
    breaths["columns"].push_back({{"name", name},
                                  {"unit", column.unit},
                                  {"values", numbers(of_size(status.size(), column, name).values)}});
  }
  return breaths;
}

Json prediction_contents(const StoredFile& file) {
  Json predictions = Json::array();
  for (const std::string& name : file.groups("predictions"))
    predictions.push_back({{"name", name},
                           {"scenario", file.attribute("predictions/" + name, "scenario")},
                           {"numbers", numbers_in(file, "predictions/" + name)}});
  return predictions;
}

}  // namespace

Json fit_contents(const StoredFile& file, Packed& packed) {
  return {{"measured", measured_contents(file, packed)},
          {"result", result_contents(file, packed)},
          {"parameters", parameter_contents(file)},
          {"surface", surface_contents(file, packed)},
          {"profiles", profile_contents(file)},
          {"convergence", convergence_contents(file, packed)},
          {"breaths", breath_contents(file)},
          {"predictions", prediction_contents(file)}};
}

}  // namespace trunk
