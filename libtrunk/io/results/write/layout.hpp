#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "results/hdf5/write.hpp"
#include "results/records.hpp"

/// Private to the results layer: the parts that several kinds of files share.
namespace trunk::layout {

/// The version of the layout that is written. Files of earlier versions are read too. A fit of version 1 has
/// no results with grades.
constexpr std::int32_t schema_version(std::string_view kind) {
  return kind == "fit" ? 2 : 1;
}

/// Builds a file of a kind ("run", "fit", "sweep") and stores it at `path`. Writes the attribute `complete`
/// last. Throws std::runtime_error with the path and the cause.
void store(const std::filesystem::path& path, const std::string& kind,
           const std::function<void(hid_t root)>& fill);

/// Writes the kind of record that a group holds.
void write_schema(hid_t group, const std::string& kind);

/// Writes all parts of a run except its provenance.
void write_run_content(hid_t group, const RunRecord& run);
void write_trajectory(hid_t group, const Trajectory& trajectory, const std::string& version_of_trunk);
/// Writes the trajectory in the format of VTK, without a copy of its numbers.
void write_vtkhdf(hid_t group, const Trajectory& trajectory);

void write_provenance(hid_t group, const Provenance& provenance);
void write_numbers(hid_t group, const std::vector<NamedValue>& numbers);

/// Writes the choices behind structural intervals into a group of their own; nothing if there are none.
void write_structure(hid_t group, const Structure& structure);

/// Writes the results of a fit with their grades, the gates, and what straight lines give.
void write_results(hid_t root, const FitRecord& fit);

/// Returns whether SOURCE_DATE_EPOCH is set. If it is, values that differ between equal runs (times, host,
/// command line) are left out.
bool is_reproducible();

/// Returns whether a quantity of this name is such a time.
bool is_clock_time(const std::string& name);

/// Returns a unit in the spelling of files: "1" for a pure number, "N m-1" for N/m.
std::string file_unit(const std::string& unit);

/// Converts m³ to ml.
std::vector<double> to_ml(const std::vector<double>& volumes_m3);

}  // namespace trunk::layout
