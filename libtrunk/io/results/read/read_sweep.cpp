#include "results/read/read_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "errors/input_error.hpp"
#include "results/hdf5/read.hpp"
#include "results/read/open_results.hpp"
#include "results/read/read_parts.hpp"

namespace trunk {
namespace {

template <typename Value>
std::vector<Value> beginning(std::vector<Value> column, std::size_t runs, std::size_t rows,
                             const std::string& name) {
  if (column.size() != runs) throw hdf5::Error("table/" + name + " has the wrong length");
  column.resize(rows);
  return column;
}

void read_table(hid_t root, std::size_t most_runs, StoredSweep& sweep) {
  const hdf5::Group table = hdf5::open_group(root, "table");
  sweep.status = hdf5::read_texts(table, "status");
  const std::size_t runs = sweep.runs = sweep.status.size(), rows = std::min(runs, most_runs);
  sweep.status.resize(rows);
  const auto texts = [&](const char* name) {
    if (!hdf5::has_link(table, name)) return std::vector<std::string>();
    return beginning(hdf5::read_texts(table, name), runs, rows, name);
  };
  sweep.scenario = texts("scenario");
  sweep.subject = texts("subject");
  sweep.error = texts("error");
  for (const std::string& name : hdf5::link_names(table)) {
    if (name == "run") continue;
    const std::string unit = hdf5::read_attribute_if_any(hdf5::open_dataset(table, name), "units");
    if (unit.empty()) continue;  // a text
    sweep.columns.push_back({name, unit, beginning(hdf5::read_doubles(table, name), runs, rows, name)});
  }
}

void read_first_curves(hid_t root, StoredSweep& sweep) {
  constexpr std::size_t most_values = 100'000'000;
  if (!hdf5::has_link(root, "curves")) return;
  const hdf5::Group curves = hdf5::open_group(root, "curves");
  sweep.curve_time_s = hdf5::read_doubles(curves, "time");
  const hsize_t rows = sweep.status.size(), samples = sweep.curve_time_s.size();
  const hdf5::Dataset dataset = hdf5::open_dataset(curves, "dV");
  if (hdf5::shape_of(dataset) != std::vector<hsize_t>{sweep.runs, samples})
    throw hdf5::Error("curves/dV has the wrong shape");
  if (rows == 0 || samples == 0) return;
  if (samples > most_values / rows) throw hdf5::Error("curves/dV is too large");
  const hsize_t start[2] = {0, 0}, count[2] = {rows, samples};
  const hdf5::Space all(H5Dget_space(dataset), "read curves/dV"),
      part(H5Screate_simple(2, count, nullptr), "read curves/dV");
  hdf5::require(H5Sselect_hyperslab(all, H5S_SELECT_SET, start, nullptr, count, nullptr), "read curves/dV");
  sweep.curve_dV_ml.resize(rows * samples);
  hdf5::require(H5Dread(dataset, H5T_NATIVE_DOUBLE, part, all, H5P_DEFAULT, sweep.curve_dV_ml.data()),
                "read curves/dV");
}

}  // namespace

StoredSweep read_sweep(const std::filesystem::path& path, std::size_t most_runs) {
  StoredSweep sweep;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind != "sweep") throw InputError({path.string()}, fmt::format("is a {}", kind), "a sweep");
    sweep.title = hdf5::read_attribute(root, "title");
    sweep.sweep_toml = hdf5::read_text(root, "sweep_toml");
    read_table(root, most_runs, sweep);
    read_first_curves(root, sweep);
    sweep.provenance = layout::read_provenance(root);
  });
  return sweep;
}

}  // namespace trunk
