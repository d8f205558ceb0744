#include "pml/xml_names.hpp"

#include <fmt/format.h>

#include "text/message_text.hpp"

namespace trunk::pml {
namespace {

pugi::xml_attribute declaration(pugi::xml_node at, const std::string& name) {
  for (; at; at = at.parent())
    if (const pugi::xml_attribute found = at.attribute(name.c_str())) return found;
  return {};
}

}  // namespace

QualifiedName qualified(const XmlDocument& xml, pugi::xml_node at, std::string_view name, bool by_default) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return {by_default ? declaration(at, "xmlns").value() : "", name};
  const std::string prefix(name.substr(0, colon));
  if (prefix == "xml") return {"http://www.w3.org/XML/1998/namespace", name.substr(colon + 1)};
  const pugi::xml_attribute found = declaration(at, "xmlns:" + prefix);
  if (!found)
    xml.fail(at, fmt::format("unknown namespace prefix in {}", excerpt(name)),
             fmt::format("xmlns:{}=\"…\" above it", prefix), "declare it");
  return {found.value(), name.substr(colon + 1)};
}

std::string_view load_name(const XmlDocument& xml, pugi::xml_node element) {
  const QualifiedName name = qualified(xml, element, element.name(), true);
  if (name.space != load_namespace)
    xml.fail(element, fmt::format("<{}> in namespace {}", element.name(), excerpt(name.space)),
             excerpt(load_namespace), "name it with xmlns");
  return name.local;
}

bool declares_namespace(std::string_view attribute) noexcept {
  return attribute == "xmlns" || attribute.starts_with("xmlns:");
}

}  // namespace trunk::pml
