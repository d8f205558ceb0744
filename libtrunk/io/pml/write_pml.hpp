#pragma once

#include <string>

#include "pml/physical_model.hpp"

namespace trunk::pml {

/// Returns the model as a PML text that CamiTK reads, with all digits of the numbers, with counts, and
/// without an empty informative part. The text is read back and compared with the model. Throws InputError if
/// the model breaks a rule of read_pml or is not read back equal, for example because of a NaN, an attribute
/// named "index" or a name that XML does not allow.
std::string write_pml(const PhysicalModel& model);

}  // namespace trunk::pml
