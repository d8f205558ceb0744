#pragma once

#include <string>
#include <vector>

#include "results/hdf5/id.hpp"
#include "results/records.hpp"

/// Private to the results layer.
namespace trunk::layout {

/// Returns the single numbers in a group in the order of writing. A pure number has the unit "1".
std::vector<NamedValue> read_numbers(hid_t root, const std::string& group);

/// Returns the best parameters of a fit.
std::vector<NamedValue> read_best_parameters(hid_t root);

}  // namespace trunk::layout
