#pragma once

#include <string>
#include <string_view>

#include "pml/physical_model.hpp"

namespace trunk::pml {

/// Returns the model of a PML text in UTF-8. Messages name `file`.
///
/// The counts nrOfStructures, nrOfAtoms, nrOfCells … only help other programs to reserve memory, and existing
/// files have wrong ones. They must be whole numbers, but they need not agree with the content.
///
/// Throws InputError with a line for malformed XML, unknown elements and cell types, coordinates that are
/// missing or not finite, indexes that occur twice or refer to nothing, a wrong number of atoms for the type
/// of a cell, an empty informative multiComponent, more than 64 levels, and texts longer than 100 MB.
PhysicalModel read_pml(std::string_view text, const std::string& file);

}  // namespace trunk::pml
