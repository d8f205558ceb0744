#pragma once

#include <pugixml.hpp>
#include <string>

#include "pml/attributes.hpp"

/// Private to the pml layer: writing of XML.
namespace trunk::pml {

/// Returns the shortest decimal number that is read back as the same double.
std::string shortest(double value);

/// Adds an element or attributes to an element.
pugi::xml_node add(pugi::xml_node parent, const char* element);
void add_attribute(pugi::xml_node to, const std::string& name, const std::string& value);
void add_attributes(pugi::xml_node to, const Attributes& attributes);

/// Adds the XML declaration (UTF-8) to an empty document.
void declare(pugi::xml_document& document);

/// Returns the document as text with one element on each line, without indentation.
std::string text_of(const pugi::xml_document& document);

}  // namespace trunk::pml
