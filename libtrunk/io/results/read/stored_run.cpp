#include "results/read/stored_run.hpp"

#include <fmt/format.h>

#include "errors/input_error.hpp"
#include "results/hdf5/read.hpp"
#include "results/read/open_results.hpp"
#include "results/read/read_numbers.hpp"

namespace trunk {
namespace {

void read_curve(hid_t root, StoredRun& run) {
  if (!hdf5::has_link(root, "curves") || !hdf5::has_link(root, "curves/time")) return;
  run.curve_time_s = hdf5::read_doubles(root, "curves/time");
  if (!hdf5::has_link(root, "curves/dV_model")) return;
  const std::string unit = hdf5::read_attribute(hdf5::open_dataset(root, "curves/dV_model"), "units");
  if (unit != "ml") throw hdf5::Error(fmt::format("curves/dV_model is in '{}' instead of ml", unit));
  run.curve_dV_ml = hdf5::read_doubles(root, "curves/dV_model");
  if (run.curve_dV_ml.size() != run.curve_time_s.size()) {
    throw hdf5::Error("curves/dV_model and curves/time differ in length");
  }
}

}  // namespace

std::vector<NamedValue> read_parameters(const std::filesystem::path& path) {
  std::vector<NamedValue> parameters;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind == "sweep") throw InputError({path.string()}, "is a sweep", "a run or a fit");
    parameters =
        kind == "run" ? layout::read_numbers(root, "parameters") : layout::read_best_parameters(root);
  });
  return parameters;
}

RunInputs read_run_inputs(const std::filesystem::path& path) {
  RunInputs inputs;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind == "sweep") throw InputError({path.string()}, "is a sweep", "a run or a fit");
    const std::string parameters = kind == "run" ? "parameters/" : "best_run/parameters/";
    inputs.scenario_toml = hdf5::read_text(root, parameters + "scenario_toml");
    if (hdf5::has_link(root, parameters + "trunk_pml"))
      inputs.trunk_pml = hdf5::read_text(root, parameters + "trunk_pml");
  });
  return inputs;
}

StoredRun read_stored_run(const std::filesystem::path& path) {
  StoredRun run;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind != "run") throw InputError({path.string()}, fmt::format("is a {}", kind), "a run");
    run.title = hdf5::read_attribute(root, "title");
    run.status = hdf5::read_attribute(root, "status");
    run.message = hdf5::read_attribute(root, "message");
    run.parameters = layout::read_numbers(root, "parameters");
    run.measures = layout::read_numbers(root, "measures");
    if (hdf5::has_link(root, "intervals")) run.intervals = layout::read_numbers(root, "intervals");
    read_curve(root, run);
  });
  return run;
}

}  // namespace trunk
