#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/hdf5/write.hpp"
#include "results/records.hpp"

/// Private to the results layer: the parts that several kinds of file share.
namespace trunk::layout {

inline constexpr std::int32_t schema_version = 1;

/// Builds a file of a kind ("run", "fit", "sweep") and stores it at `path`; `complete` is written last.
void store(const std::filesystem::path& path, const std::string& kind,
           const std::function<void(hid_t root)>& fill);

/// Marks a group as holding a kind of record.
void write_schema(hid_t group, const std::string& kind);

/// All that a run consists of but its provenance.
void write_run_content(hid_t group, const RunRecord& run);
void write_trajectory(hid_t group, const Trajectory& trajectory, const std::string& version_of_trunk);
/// The trajectory once more as VTK wants it, without a copy of its numbers.
void write_vtkhdf(hid_t group, const Trajectory& trajectory);

void write_provenance(hid_t group, const Provenance& provenance);
void write_numbers(hid_t group, const std::vector<NamedValue>& numbers);

/// True under SOURCE_DATE_EPOCH: what differs between two equal runs (times, host, command line) is left out.
bool is_reproducible();

/// Whether a quantity of this name is such a time.
bool is_clock_time(const std::string& name);

/// As files spell it: a pure number is "1", N/m is "N m-1".
std::string file_unit(const std::string& unit);

/// m³ => ml
std::vector<double> to_ml(const std::vector<double>& volumes_m3);

}  // namespace trunk::layout
