#pragma once

#include <string>
#include <vector>

#include "pml/loads.hpp"
#include "pml/xml_document.hpp"

/// Private to the pml layer: the text of the element appliedTo.
namespace trunk::pml {

/// The most atoms that one load may name by index, so that a list is never long to work out.
inline constexpr std::size_t most_indices = 10'000'000;

/// "0-3,7,9-11", names of components, or "*", separated by commas. Throws InputError at the element.
std::vector<LoadTarget> read_load_targets(const XmlDocument& xml, pugi::xml_node applied_to);

/// The text that reads so.
std::string text_of(const std::vector<LoadTarget>& targets);

}  // namespace trunk::pml
