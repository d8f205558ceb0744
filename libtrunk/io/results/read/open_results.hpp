#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/hdf5/id.hpp"

/// Private to the results layer.
namespace trunk::layout {

/// Opens a finished results file and hands its root group and kind ("run", "fit", "sweep") to `use`.
/// Throws InputError that says which it is: missing, not HDF5, truncated or damaged, made by another
/// program, of a newer schema, unfinished; also for whatever goes wrong with HDF5 within `use`.
void read_results(const std::filesystem::path& path,
                  const std::function<void(hid_t root, const std::string& kind)>& use);

}  // namespace trunk::layout
