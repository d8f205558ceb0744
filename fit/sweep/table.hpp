#pragma once

#include "sweep/design.hpp"
#include "sweep/folder.hpp"

namespace trunk {

/// Counts of the runs in a table.
struct TableOutcome {
  std::size_t runs = 0, failed = 0, missing = 0;
};

/// Writes the rows of all shards to sweep.h5 and table.csv, by run number, and replaces both files. So the
/// table does not depend on threads, lanes, shards or interruptions. Runs that have no row are "missing".
/// Throws InputError if a file cannot be written.
TableOutcome write_table(const SweepDesign& design, const SweepFolder& folder, const std::string& argv);

}  // namespace trunk
