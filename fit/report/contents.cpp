#include "report/contents.hpp"

#include <cmath>

#include "errors/input_error.hpp"
#include "results/read/read_records.hpp"
#include "results/read/results_kind.hpp"

namespace trunk {

using Json = Packed::Json;

namespace {

Json provenance_contents(const Provenance& p) {
  Json json{{"software", "trunk " + p.version},
            {"commit", p.git_sha + (p.git_dirty ? " (changed)" : "")},
            {"compiler", p.compiler},
            {"command", p.argv}};
  for (const auto& [name, hash] : p.input_sha256) json["sha256 of " + name] = hash;
  return json;
}

Json heading(const std::string& title, const std::string& status, const std::string& message,
             const Provenance& provenance) {
  return {{"title", title},
          {"status", status},
          {"message", message},
          {"provenance", provenance_contents(provenance)}};
}

/// Returns what `pack` returns. An error that it throws gets the file as its place.
template <typename Pack>
Json packed_from(const std::filesystem::path& path, Pack pack) {
  try {
    return pack();
  } catch (const InputError& error) {
    rethrow_at({path.string()}, error);
  }
}

Json contents_of(const std::filesystem::path& path, const std::string& kind, std::size_t trajectory_bytes,
                 Packed& packed) {
  if (kind == "sweep") {
    const StoredSweep sweep = read_sweep(path, most_sweep_rows);
    Json contents = heading(sweep.title, "", "", sweep.provenance);
    contents["sweep"] = sweep_contents(sweep, packed);
    return contents;
  }
  if (kind == "run") {
    const RunRecord run = read_run(path);
    Json contents = heading(run.title, run.status, run.message, run.provenance);
    contents["run"] = packed_from(path, [&] { return run_contents(run, trajectory_bytes, packed); });
    return contents;
  }
  const FitRecord fit = read_fit(path);
  Json contents = heading(fit.title, fit.status, fit.message, fit.provenance);
  contents["fit"] = packed_from(path, [&] { return fit_contents(fit, packed); });
  contents["run"] = packed_from(path, [&] { return run_contents(fit.best_run, trajectory_bytes, packed); });
  return contents;
}

}  // namespace

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_list(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(number_or_null(v));
  return list;
}

Json json_table(const std::vector<NamedValue>& values) {
  Json list = Json::array();
  for (const NamedValue& v : values)
    list.push_back({{"name", v.name}, {"unit", v.unit}, {"value", number_or_null(v.value)}});
  return list;
}

Json packed_if_any(const std::vector<double>& values, std::size_t size, const char* name, Packed& packed) {
  if (values.empty()) return nullptr;
  if (values.size() != size)
    throw InputError({},
                     std::string("is damaged: ") + name + " has " + std::to_string(values.size()) + " values",
                     std::to_string(size));
  return packed.add(values);
}

Json file_contents(const std::filesystem::path& path, std::size_t trajectory_bytes, Packed& packed) {
  const std::string kind = kind_of(path);
  Json contents{{"name", path.filename().string()}, {"kind", kind}};
  contents.update(contents_of(path, kind, trajectory_bytes, packed));
  return contents;
}

}  // namespace trunk
