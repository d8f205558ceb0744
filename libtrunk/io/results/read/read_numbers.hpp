#pragma once

#include <string>
#include <vector>

#include "results/hdf5/id.hpp"
#include "results/records.hpp"

/// Private to the results layer.
namespace trunk::layout {

/// The single numbers in a group, in the order written; a pure number has the unit "1".
std::vector<NamedValue> read_numbers(hid_t root, const std::string& group);

/// The best parameters of a fit.
std::vector<NamedValue> read_best_parameters(hid_t root);

}  // namespace trunk::layout
