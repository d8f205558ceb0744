#pragma once

#include <filesystem>

#include "report/packed.hpp"
#include "results/read/read_sweep.hpp"
#include "results/records.hpp"

namespace trunk {

/// Returns what a page shows of one results file: texts and small tables as JSON, and long arrays in
/// `packed`. Anything that the file does not hold is absent or null. Throws InputError at `path` if the file
/// is not a finished results file, or if it is damaged.
///
/// Trajectories are thinned to at most `trajectory_bytes`. Positions are int16 multiples of `step_m`; each
/// frame but the first holds the change from the frame before, which makes the compressed page ten times
/// smaller.
Packed::Json file_contents(const std::filesystem::path& path, std::size_t trajectory_bytes, Packed& packed);

/// Return the parts of it. Throw InputError without a place if an array has the wrong length.
Packed::Json run_contents(const RunRecord& run, std::size_t trajectory_bytes, Packed& packed);
Packed::Json fit_contents(const FitRecord& fit, Packed& packed);
inline constexpr std::size_t most_sweep_rows = 5000;  // shown of a sweep
Packed::Json sweep_contents(const StoredSweep& sweep, Packed& packed);

/// Return numbers as JSON; NaN and infinity become null.
Packed::Json number_or_null(double value);
Packed::Json json_list(const std::vector<double>& values);

/// Returns [{name, unit, value}, ...].
Packed::Json json_table(const std::vector<NamedValue>& values);

/// Returns the packed values, or null if there are none; throws InputError with the name unless there are
/// `size`.
Packed::Json packed_if_any(const std::vector<double>& values, std::size_t size, const char* name,
                           Packed& packed);

}  // namespace trunk
