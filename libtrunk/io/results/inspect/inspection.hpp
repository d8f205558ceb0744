#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "results/records.hpp"

/// Private to the results layer.
namespace trunk::layout {

struct DatasetInfo {
  std::string path, units, long_name, type;
  std::vector<std::uint64_t> shape;  ///< empty for a single value
  std::uint64_t stored_bytes = 0;    ///< compressed
};

/// The summary of a results file, for text and JSON.
struct Inspection {
  std::string kind;
  std::uint64_t file_bytes = 0;
  std::vector<std::pair<std::string, std::string>> heading;     ///< title, status, verdict …
  std::vector<std::pair<std::string, std::string>> provenance;  //
  std::vector<NamedValue> parameters;                           ///< of a run
  FitRecord fit;                       ///< of a fit: estimates, results, gates and notes alone
  std::vector<NamedValue> measures;    ///< of a run, or of the best run of a fit
  std::vector<NamedValue> statistics;  ///< of a fit
  std::vector<std::pair<std::string, std::size_t>> run_status;  ///< of a sweep: status and number of runs
  std::vector<DatasetInfo> datasets;
};

/// Reads the whole file and all its checksums; throws InputError as read_results does.
Inspection inspect_results(const std::filesystem::path& path);

}  // namespace trunk::layout
