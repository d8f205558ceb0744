#pragma once

#include <string>
#include <string_view>

#include "pml/physical_model.hpp"

namespace trunk::pml {

/// Reads a PML text in UTF-8. `file` is named in messages.
/// The counts nrOfStructures, nrOfAtoms, nrOfCells … only help other programs to reserve memory and are wrong
/// in files that exist: whole numbers are asked for, agreement is not. Throws InputError with a line for
/// malformed XML, unknown elements and cell types, missing or non-finite coordinates, indexes that occur
/// twice or refer to nothing, a wrong number of atoms for the type of a cell, an informative multiComponent
/// with nothing in it, nesting deeper than 64, texts longer than 100 MB.
PhysicalModel read_pml(std::string_view text, const std::string& file);

}  // namespace trunk::pml
