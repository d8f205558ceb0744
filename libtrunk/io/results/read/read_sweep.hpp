#pragma once

#include <filesystem>

#include "results/records.hpp"

namespace trunk {

/// The first r of the R runs in the table of a sweep, since a sweep may be larger than the memory.
struct StoredSweep {
  std::string title, sweep_toml;
  std::size_t runs = 0;                                       ///< R
  std::vector<NamedColumn> columns;                           ///< parameters and measures, each [r]
  std::vector<std::string> scenario, subject, status, error;  ///< [r]; subject may be empty
  std::vector<double> curve_time_s;                           ///< [Tc]
  std::vector<double> curve_dV_ml;                            ///< [r*Tc], row-major
  Provenance provenance;
};

/// Reads at most `most_runs` runs of a sweep; throws InputError if the file is not a sweep, or if it is
/// damaged.
StoredSweep read_sweep(const std::filesystem::path& path, std::size_t most_runs);

}  // namespace trunk
