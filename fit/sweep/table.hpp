#pragma once

#include "sweep/design.hpp"
#include "sweep/folder.hpp"

namespace trunk {

struct TableOutcome {
  std::size_t runs = 0, failed = 0, missing = 0;
};

/// Puts the rows of all shards together in sweep.h5 and table.csv, by run number, so that neither threads,
/// lanes, shards nor an interruption show. Replaces both. Runs that have no row are "missing".
TableOutcome write_table(const SweepDesign& design, const SweepFolder& folder, const std::string& argv);

}  // namespace trunk
