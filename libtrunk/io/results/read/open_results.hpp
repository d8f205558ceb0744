#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/hdf5/id.hpp"

/// Private to the results layer.
namespace trunk::layout {

/// Opens a finished results file and calls `use` with its root group and its kind ("run", "fit" or "sweep").
/// Throws InputError if the file is missing, not HDF5, truncated, damaged, unfinished, from another program
/// or of a newer schema, and if HDF5 fails within `use`.
void read_results(const std::filesystem::path& path,
                  const std::function<void(hid_t root, const std::string& kind)>& use);

}  // namespace trunk::layout
