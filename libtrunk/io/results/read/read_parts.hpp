#pragma once

#include "results/hdf5/id.hpp"
#include "results/records.hpp"

/// Private to the results layer: the parts that records share. All functions throw hdf5::Error.
namespace trunk::layout {

RunRecord read_run_content(hid_t group);
Provenance read_provenance(hid_t group);

/// Reads what write_structure wrote into the group; an empty one if there is nothing.
Structure read_structure(hid_t group);

/// Reads only the table of parameters into an empty record.
void read_estimates(hid_t root, FitRecord& fit);

/// Returns the gates; none in a file of version 1.
std::vector<FitRecord::Gate> read_gates_of_fit(hid_t root);

/// Reads the results with their grades, the gates, what straight lines give, and the name of the input. A
/// file of version 1 has none of these, and the record stays as it is.
void read_results_of_fit(hid_t root, FitRecord& fit);

}  // namespace trunk::layout
