#pragma once

#include "results/hdf5/id.hpp"
#include "results/records.hpp"

/// Private to the results layer.
namespace trunk::layout {

RunRecord read_run_content(hid_t group);
Provenance read_provenance(hid_t group);

/// The table of parameters alone, into an empty record.
void read_estimates(hid_t root, FitRecord& fit);

}  // namespace trunk::layout
