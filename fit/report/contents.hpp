#pragma once

#include <filesystem>

#include "report/packed.hpp"
#include "results/stored_file.hpp"

namespace trunk {

/// What a page shows of one results file: texts and small tables as JSON, everything long in `packed`. What
/// the file does not hold is absent; why something could not be derived stands in `notes`. Throws InputError
/// where the file is not a finished results file, or is damaged.
///
/// Trajectories are thinned to at most `trajectory_bytes`, as int16 of `trajectory.step_m`, each frame but
/// the first less the one before it: a tenth of the size after compression.
Packed::Json file_contents(const std::filesystem::path& path, std::size_t trajectory_bytes, Packed& packed);

/// The parts of it. `at` is where the run is in the file: "" or "best_run/".
Packed::Json run_contents(const StoredFile& file, const std::string& at, const std::string& name,
                          std::size_t trajectory_bytes, Packed& packed);
Packed::Json fit_contents(const StoredFile& file, Packed& packed);
Packed::Json sweep_contents(const StoredFile& file, Packed& packed);

/// The single numbers of a group: [{name, unit, value}].
Packed::Json numbers_in(const StoredFile& file, const std::string& group);

/// NaN and infinity are null.
Packed::Json numbers(const std::vector<double>& values);

/// Throws InputError, naming the path, unless `array` has `size` values.
const StoredArray& of_size(std::size_t size, const StoredArray& array, const std::string& path);

}  // namespace trunk
