#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// What a sweep needs from a run that was done before.
struct StoredRun {
  std::string title, status, message;
  std::vector<NamedValue> parameters, measures;  ///< in the order written
  std::vector<double> curve_time_s;              ///< [Tc]
  std::vector<double> curve_dV_ml;               ///< [Tc]; empty when the run has no curve `dV_model`
};

/// The parameters of a run, or the best ones of a fit. Throws InputError for anything else.
std::vector<NamedValue> read_parameters(const std::filesystem::path& path);

/// What a run, or the best run of a fit, can be repeated from.
struct RunInputs {
  std::string scenario_toml;
  std::string trunk_pml;  ///< "" for the parametric trunk
};

/// Throws InputError when the file is neither a finished run nor a finished fit.
RunInputs read_run_inputs(const std::filesystem::path& path);

/// Throws InputError when the file is not a finished run, or is damaged in what is read.
StoredRun read_stored_run(const std::filesystem::path& path);

}  // namespace trunk
