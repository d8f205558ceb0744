#pragma once

#include <string>

#include "pml/physical_model.hpp"

namespace trunk::pml {

/// The model as a PML text that CamiTK reads: numbers with all their digits, counts filled in, an empty
/// informative part left out. What is written has been read back and compared: throws InputError when the
/// model breaks a rule of read_pml or would not come back equal (a NaN, an attribute called "index", a name
/// that is no XML name).
std::string write_pml(const PhysicalModel& model);

}  // namespace trunk::pml
