#pragma once

#include <pugixml.hpp>
#include <string>

#include "pml/attributes.hpp"

/// Private to the pml layer.
namespace trunk::pml {

/// The shortest decimal number that reads back as the same double.
std::string shortest(double value);

pugi::xml_node add(pugi::xml_node parent, const char* element);
void add_attribute(pugi::xml_node to, const std::string& name, const std::string& value);
void add_attributes(pugi::xml_node to, const Attributes& attributes);

/// An empty document in UTF-8 with its XML declaration.
void declare(pugi::xml_document& document);

/// The document as text, one element a line, not indented.
std::string text_of(const pugi::xml_document& document);

}  // namespace trunk::pml
