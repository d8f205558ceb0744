#include "results/write/write_sweep.hpp"

#include <algorithm>

#include "results/write/layout.hpp"

namespace trunk {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_array, hdf5::write_axis;

/// Returns the axis of the runs, for the curves.
Axis write_table(hid_t root, const SweepRecord& sweep) {
  const Group table = create_group(root, "table");
  Axis run = write_count_axis(table, {"run", "1", "run"}, sweep.status.size());
  write_array(table, {"scenario", "", "scenario"}, sweep.scenario, {run});
  if (!sweep.subject.empty()) write_array(table, {"subject", "", "subject"}, sweep.subject, {run});
  for (const NamedColumn& column : sweep.columns) {
    if (layout::is_reproducible() && layout::is_clock_time(column.name)) continue;
    write_array(table, {column.name, layout::file_unit(column.unit), ""}, column.values, {run});
  }
  write_array(table, {"status", "", "how the run ended"}, sweep.status, {run});
  write_array(table, {"error", "", "why it failed"}, sweep.error, {run});
  write_array(table, {"run_file", "", "its file, relative to the folder of this file"}, sweep.run_file,
              {run});
  return run;
}

/// Copies the curves, because a virtual dataset silently reads NaN if a file is missing.
void write_curves(hid_t root, const SweepRecord& sweep, const Axis& run) {
  const Group curves = create_group(root, "curves");
  hdf5::link_again(root, "table/run", curves, "run");
  const Axis time = write_axis(curves, {"time", "s", "time"}, sweep.curve_time_s);
  hdf5::write_rows(curves, {"dV", "ml", "volume change of the model"}, sweep.fill_curves_ml, run, time);
}

std::string five_digits(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(5 - std::min<std::size_t>(5, digits.size()), '0') + digits;
}

void link_runs(hid_t root, const SweepRecord& sweep) {
  const Group runs = create_group(root, "runs");
  for (std::size_t run = 0; run < sweep.run_file.size(); ++run) {
    if (sweep.run_file[run].empty()) continue;
    hdf5::require(H5Lcreate_external(sweep.run_file[run].c_str(), "/", runs, five_digits(run).c_str(),
                                     H5P_DEFAULT, H5P_DEFAULT),
                  "link " + sweep.run_file[run]);
  }
}

}  // namespace

void write_sweep(const std::filesystem::path& path, const SweepRecord& sweep) {
  layout::store(path, "sweep", [&](hid_t root) {
    hdf5::write_attribute(root, "title", sweep.title);
    hdf5::write_text(root, {"sweep_toml", "", "the sweep as it was given"}, sweep.sweep_toml);
    const Axis run = write_table(root, sweep);
    write_curves(root, sweep, run);
    link_runs(root, sweep);
    layout::write_provenance(root, sweep.provenance);
  });
}

}  // namespace trunk
