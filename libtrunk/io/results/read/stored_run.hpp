#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/records.hpp"

namespace trunk {

/// The part of a finished run that a sweep needs.
struct StoredRun {
  std::string title, status, message;
  std::vector<NamedValue> parameters, measures;  ///< in the order of writing
  std::vector<NamedValue> intervals;             ///< of the measures; empty if the run has none
  std::vector<double> curve_time_s;              ///< [Tc]
  std::vector<double> curve_dV_ml;               ///< [Tc]; empty if the run has no curve `dV_model`
};

/// Returns the parameters of a run, or the best parameters of a fit; throws InputError if the file is
/// neither.
std::vector<NamedValue> read_parameters(const std::filesystem::path& path);

/// The inputs with which a run, or the best run of a fit, can be repeated.
struct RunInputs {
  std::string scenario_toml;
  std::string trunk_pml;  ///< "" for the parametric trunk
};

/// Reads the inputs of a run; throws InputError if the file is neither a finished run nor a finished fit.
RunInputs read_run_inputs(const std::filesystem::path& path);

/// Reads a run; throws InputError if the file is not a finished run, or if the part that is read is damaged.
StoredRun read_stored_run(const std::filesystem::path& path);

}  // namespace trunk
