#pragma once

#include <string>

#include "pml/loads.hpp"

namespace trunk::pml {

/// Returns the loads as an LML text that CamiTK reads, with all digits of the numbers. The text is read back
/// and compared with the loads. Throws InputError if the loads break a rule of read_lml or are not read back
/// equal.
std::string write_lml(const Loads& loads);

}  // namespace trunk::pml
