#include "errors/input_error.hpp"
#include "results/hdf5/read.hpp"
#include "results/open_results.hpp"
#include "results/read_parts.hpp"
#include "results/read_records.hpp"

namespace trunk {
namespace {

/// A column of texts; empty when there is none.
std::vector<std::string> read_column(hid_t table, const std::string& name, std::size_t runs) {
  if (!hdf5::has_link(table, name)) return {};
  std::vector<std::string> texts = hdf5::read_texts(table, name);
  if (texts.size() != runs) throw hdf5::Error("table/" + name + " has the wrong length");
  return texts;
}

void read_table(hid_t root, SweepRecord& sweep) {
  const hdf5::Group table = hdf5::open_group(root, "table");
  sweep.status = hdf5::read_texts(table, "status");
  const std::size_t runs = sweep.status.size();
  sweep.scenario = read_column(table, "scenario", runs);
  sweep.error = read_column(table, "error", runs);
  sweep.run_file = read_column(table, "run_file", runs);
  for (const std::string& name : hdf5::link_names(table)) {
    if (name == "run") continue;
    const hdf5::Dataset dataset = hdf5::open_dataset(table, name);
    if (!hdf5::has_attribute(dataset, "units")) continue;  // a text
    NamedColumn column{name, hdf5::read_attribute(dataset, "units"), hdf5::read_doubles(table, name)};
    if (column.values.size() != runs) throw hdf5::Error("table/" + name + " has the wrong length");
    sweep.columns.push_back(std::move(column));
  }
}

void read_sweep_curves(hid_t root, SweepRecord& sweep) {
  if (!hdf5::has_link(root, "curves")) return;
  const hdf5::Group curves = hdf5::open_group(root, "curves");
  sweep.curve_time_s = hdf5::read_doubles(curves, "time");
  sweep.curve_dV_ml = hdf5::read_doubles(curves, "dV");
  if (sweep.curve_dV_ml.size() != sweep.status.size() * sweep.curve_time_s.size())
    throw hdf5::Error("curves/dV has the wrong shape");
}

}  // namespace

SweepRecord read_sweep(const std::filesystem::path& path) {
  SweepRecord sweep;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind != "sweep") throw InputError(path.string(), 0, "is a " + kind + ", expected a sweep");
    sweep.title = hdf5::read_attribute(root, "title");
    sweep.sweep_toml = hdf5::read_text(root, "sweep_toml");
    read_table(root, sweep);
    read_sweep_curves(root, sweep);
    sweep.provenance = layout::read_provenance(root);
  });
  return sweep;
}

}  // namespace trunk
