#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "recordings/recording.hpp"

namespace trunk {

/// Returns whether a file that starts with these bytes (at least 128, if it has them) is a MAT-file of
/// version 5, 7 or 7.3.
bool is_matlab(std::string_view start);

/// Opens a MAT-file. Its channels are its vectors, the columns of its matrices (or the rows, if they are
/// longer), and the fields of its structs.
///  - A scalar with a name like fs, srate or sampling_rate is the sampling rate of all channels.
///  - A scalar dt, ts or isi is the sampling interval, in s or in the unit that isi_units gives.
///  - A text flow_units is the unit of the channel flow.
///  - A list of texts such as labels, titles or names gives the names of the columns of a matrix if it has as
///    many entries, and a list units gives their units.
///
///  - A file of LabChart has its own channels (see LabChartVariables): those of `block`, from 1, or of the
///    longest one if it is 0, which a note says.
///
/// Throws InputError if the file is damaged, or if it has no vector of numbers or no such block.
std::unique_ptr<Recording> open_matlab(const std::filesystem::path& path, std::size_t block = 0);

}  // namespace trunk
