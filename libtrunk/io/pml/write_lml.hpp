#pragma once

#include <string>

#include "pml/loads.hpp"

namespace trunk::pml {

/// The loads as an LML text that CamiTK reads, numbers with all their digits. What is written has been read
/// back and compared: throws InputError when the loads break a rule of read_lml or would not come back equal.
std::string write_lml(const Loads& loads);

}  // namespace trunk::pml
