#pragma once

#include <string_view>

#include "pml/xml_document.hpp"

/// Private to the pml layer: XML namespaces, whatever prefix a file has for them.
namespace trunk::pml {

inline constexpr std::string_view load_namespace = "http://www-timc.imag.fr/load";
inline constexpr std::string_view schema_namespace = "http://www.w3.org/2001/XMLSchema-instance";

/// A name with its namespace, empty when there is none.
struct QualifiedName {
  std::string_view space, local;
  bool operator==(const QualifiedName&) const = default;
};

/// Of a name as it stands at an element; one without prefix is in the default namespace if `by_default`.
/// Throws InputError for a prefix that nothing declares.
QualifiedName qualified(const XmlDocument& xml, pugi::xml_node at, std::string_view name, bool by_default);

/// Of an element of LML. Throws InputError when it is in another namespace.
std::string_view load_name(const XmlDocument& xml, pugi::xml_node element);

/// Whether an attribute declares a namespace: "xmlns" or "xmlns:…".
bool declares_namespace(std::string_view attribute) noexcept;

}  // namespace trunk::pml
