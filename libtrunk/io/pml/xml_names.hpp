#pragma once

#include <string_view>

#include "pml/xml_document.hpp"

/// Private to the pml layer: XML namespaces, with any prefix.
namespace trunk::pml {

inline constexpr std::string_view load_namespace = "http://www-timc.imag.fr/load";
inline constexpr std::string_view schema_namespace = "http://www.w3.org/2001/XMLSchema-instance";

/// A name with its namespace, which is empty if there is none.
struct QualifiedName {
  std::string_view space, local;
  bool operator==(const QualifiedName&) const = default;
};

/// Returns the qualified name of `name` as written at an element. A name without prefix is in the default
/// namespace if `by_default`. Throws InputError if no element declares the prefix.
QualifiedName qualified(const XmlDocument& xml, pugi::xml_node at, std::string_view name, bool by_default);

/// Returns the local name of an element of LML; throws InputError if it is in another namespace.
std::string_view load_name(const XmlDocument& xml, pugi::xml_node element);

/// Returns whether an attribute declares a namespace, as "xmlns" and "xmlns:…" do.
bool declares_namespace(std::string_view attribute) noexcept;

}  // namespace trunk::pml
