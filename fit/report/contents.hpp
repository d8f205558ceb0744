#pragma once

#include <filesystem>

#include "report/packed.hpp"
#include "results/read/read_sweep.hpp"
#include "results/records.hpp"

namespace trunk {

/// What a page shows of one results file: texts and small tables as JSON, everything long in `packed`. What
/// the file does not hold is absent or null. Throws InputError where the file is not a finished results file,
/// or is damaged.
///
/// Trajectories are thinned to at most `trajectory_bytes`, as int16 of `trajectory.step_m`, each frame but
/// the first less the one before it: a tenth of the size after compression.
Packed::Json file_contents(const std::filesystem::path& path, std::size_t trajectory_bytes, Packed& packed);

/// The parts of it.
Packed::Json run_contents(const RunRecord& run, std::size_t trajectory_bytes, Packed& packed);
Packed::Json fit_contents(const FitRecord& fit, Packed& packed);
inline constexpr std::size_t most_sweep_rows = 5000;
Packed::Json sweep_contents(const StoredSweep& sweep, Packed& packed);

/// NaN and infinity are null.
Packed::Json number_or_null(double value);
Packed::Json json_list(const std::vector<double>& values);

/// [{name, unit, value}]
Packed::Json json_table(const std::vector<NamedValue>& values);

/// Values or null where there are none; throws InputError, with the name, unless there are `size`.
Packed::Json packed_if_any(const std::vector<double>& values, std::size_t size, const char* name,
                           Packed& packed);

}  // namespace trunk
