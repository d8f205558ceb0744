#pragma once

#include <string>
#include <vector>

#include "pml/loads.hpp"
#include "pml/xml_document.hpp"

/// Private to the pml layer: the text of the element appliedTo, such as "0-3,7,9-11" or "*".
namespace trunk::pml {

/// The largest number of atoms that one load may name by index. Our choice: it bounds the time of reading.
inline constexpr std::size_t most_indices = 10'000'000;

/// Returns the indexes, ranges, names of components and "*" of an element, which are separated by commas;
/// throws InputError at the element if one is none of these.
std::vector<LoadTarget> read_load_targets(const XmlDocument& xml, pugi::xml_node applied_to);

}  // namespace trunk::pml
