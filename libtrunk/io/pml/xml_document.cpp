#include "pml/xml_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "errors/input_error.hpp"
#include "pml/text_values.hpp"

namespace trunk::pml {
namespace {

bool contains(std::initializer_list<std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(std::initializer_list<std::string_view> names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

XmlDocument::XmlDocument(std::string_view text, std::string file, std::string language)
    : text_(text), file_(std::move(file)), language_(std::move(language)) {
  check_text();
  parse();
  check_top();
}

void XmlDocument::check_text() const {
  if (text_.size() > largest_text)
    throw InputError(file_, 0,
                     fmt::format("the text has {} bytes, expected at most {} MB; split or thin it",
                                 text_.size(), largest_text / 1'000'000));
  if (const std::size_t at = first_forbidden(text_); at != std::string_view::npos)
    fail_at(at, "a control character or a byte that is not UTF-8, expected an XML text; save it as UTF-8");
}

void XmlDocument::parse() {
  const auto result = document_.load_buffer(text_.data(), text_.size(),
                                            pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!result)
    fail_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
            fmt::format("malformed XML ({}), expected a whole {} file; check that its export was finished",
                        result.description(), language_));
}

void XmlDocument::check_top() const {
  for (const pugi::xml_node node : document_.children())
    if (node.type() == pugi::node_doctype)
      fail(node, "DOCTYPE found, expected none: entities are not expanded here; remove it");
    else if (node != root())
      fail(node, fmt::format("<{}> after the end of <{}>, expected one element at the top; remove it",
                             node.name(), root().name()));
}

std::size_t XmlDocument::line_at(std::size_t offset) const {
  const auto before = text_.substr(0, std::min(offset, text_.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::size_t XmlDocument::line(pugi::xml_node at) const {
  return line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(at.offset_debug(), 0)));
}

void XmlDocument::fail_at(std::size_t offset, const std::string& text) const {
  throw InputError(file_, line_at(offset), text);
}

void XmlDocument::fail(pugi::xml_node at, const std::string& text) const {
  throw InputError(file_, line(at), text);
}

std::vector<pugi::xml_node> XmlDocument::elements(pugi::xml_node parent) const {
  for (const pugi::xml_node child : parent.children())
    if (child.type() != pugi::node_element)
      fail(child, fmt::format("text {} in <{}>, expected elements alone; remove it", cited(child.value()),
                              parent.name()));
  return {parent.begin(), parent.end()};
}

void XmlDocument::allow_elements(pugi::xml_node parent, std::initializer_list<std::string_view> names) const {
  for (const pugi::xml_node child : elements(parent))
    if (!contains(names, child.name()))
      fail(child, fmt::format("unknown element <{}> in <{}>, expected {}; remove or rename it", child.name(),
                              parent.name(), names.size() > 0 ? listed(names) : "none"));
}

pugi::xml_node XmlDocument::at_most_one(pugi::xml_node parent, const char* name) const {
  const pugi::xml_node first = parent.child(name);
  if (const pugi::xml_node second = first.next_sibling(name))
    fail(second, fmt::format("a second <{}> in <{}>, expected one; remove it", name, parent.name()));
  return first;
}

pugi::xml_node XmlDocument::only(pugi::xml_node parent, const char* name) const {
  const pugi::xml_node found = at_most_one(parent, name);
  if (!found) fail(parent, fmt::format("<{0}> without <{1}>, expected one; add it", parent.name(), name));
  return found;
}

std::string XmlDocument::text(pugi::xml_node parent) const {
  std::string whole;
  for (const pugi::xml_node child : parent.children()) {
    if (child.type() == pugi::node_element)
      fail(child,
           fmt::format("element <{}> in <{}>, expected text alone; remove it", child.name(), parent.name()));
    whole += child.value();
  }
  return std::string(trimmed(whole));
}

Attributes XmlDocument::attributes(pugi::xml_node at, std::initializer_list<std::string_view> but) const {
  std::vector<std::string_view> names;
  Attributes kept;
  for (const pugi::xml_attribute attribute : at.attributes()) {
    names.emplace_back(attribute.name());
    if (first_forbidden(attribute.value()) != std::string_view::npos)
      fail(at, fmt::format("a control character in attribute '{}' of <{}>, expected text; remove it",
                           attribute.name(), at.name()));
    if (!contains(but, attribute.name())) kept.push_back({attribute.name(), attribute.value()});
  }
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    fail(at, fmt::format("attribute '{}' twice in <{}>, expected once; remove one", *twice, at.name()));
  return kept;
}

void XmlDocument::allow_attributes(pugi::xml_node at, std::initializer_list<std::string_view> names) const {
  if (const Attributes others = attributes(at, names); !others.empty())
    fail(at, fmt::format("unknown attribute '{}' of <{}>, expected {}; remove or rename it",
                         others.front().name, at.name(), names.size() > 0 ? listed(names) : "none"));
}

std::string_view XmlDocument::value(pugi::xml_node at, const char* name) const {
  const pugi::xml_attribute attribute = at.attribute(name);
  if (!attribute) fail(at, fmt::format("<{}> without attribute '{}', expected one; add it", at.name(), name));
  return attribute.value();
}

double XmlDocument::number(pugi::xml_node at, const char* name) const {
  const auto number = finite_number(value(at, name));
  if (!number)
    fail(at, fmt::format("{}={} in <{}>, expected a finite number; correct it", name, cited(value(at, name)),
                         at.name()));
  return *number;
}

std::size_t XmlDocument::index(pugi::xml_node at, const char* name) const {
  const auto number = whole_number(value(at, name));
  if (!number)
    fail(at, fmt::format("{}={} in <{}>, expected a whole number of 0 to {}; correct it", name,
                         cited(value(at, name)), at.name(), largest_index));
  return *number;
}

}  // namespace trunk::pml
