#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/records.hpp"
#include "sweep/design.hpp"
#include "sweep/folder.hpp"

namespace trunk {

/// What the table keeps of one run.
struct SweepRow {
  std::string status, error;
  std::vector<NamedValue> measures;
  std::vector<double> curve_time_s, curve_dV_ml;
};

/// Collects rows in any order; writes them by run number, so that neither threads nor an interruption show.
class SweepTable {
 public:
  explicit SweepTable(const SweepDesign& design);

  void add(std::size_t run, std::string run_file, const SweepRow& row);
  std::size_t failures() const noexcept;

  /// Writes sweep.h5 and table.csv.
  void write(const SweepFolder& folder, const Provenance& provenance) const;

 private:
  struct Kept {
    std::string status = "missing", error, run_file;
    std::vector<NamedValue> measures;
    std::vector<double> curve;  // dV in ml every curve_step_s; shorter where the run was
  };
  std::vector<NamedColumn> columns() const;
  std::string csv() const;

  const SweepDesign& design_;
  std::vector<Kept> rows_;
};

}  // namespace trunk
