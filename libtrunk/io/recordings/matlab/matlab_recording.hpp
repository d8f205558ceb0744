#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "recordings/recording.hpp"

namespace trunk {

/// Whether a file that starts with these bytes (128 where it has them) says that it is a MAT-file (version 5,
/// 7 or 7.3).
bool is_matlab(std::string_view start);

/// The vectors of a MAT-file, the columns of its matrices (rows, where those are longer) and the fields of
/// its structs, as channels. A scalar named like fs, srate or sampling_rate is the rate of all; dt, ts or isi
/// the interval, in the unit that isi_units says, else s. A text `flow_units` is the unit of `flow`; a list
/// of texts named labels, titles or names, as long as a matrix is wide, names its columns, units likewise.
/// Throws InputError: damaged, nothing but objects, no vector.
std::unique_ptr<Recording> open_matlab(const std::filesystem::path& path);

}  // namespace trunk
