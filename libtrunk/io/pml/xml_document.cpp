#include "pml/xml_document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "errors/input_error.hpp"
#include "pml/text_values.hpp"
#include "text/message_text.hpp"

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
    throw InputError({file_}, fmt::format("the text has {} bytes", text_.size()),
                     fmt::format("at most {} MB", largest_text / 1'000'000), "split or thin it");
  if (const std::size_t at = first_forbidden(text_); at != std::string_view::npos)
    fail_at(at, "a control character or a byte that is not UTF-8", "an XML text", "save it as UTF-8");
}

void XmlDocument::parse() {
  const auto result = document_.load_buffer(text_.data(), text_.size(),
                                            pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!result)
    fail_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
            fmt::format("malformed XML ({})", result.description()),
            fmt::format("a whole {} file", language_), "check that its export was finished");
}

void XmlDocument::check_top() const {
  for (const pugi::xml_node node : document_.children())
    if (node.type() == pugi::node_doctype)
      fail(node, "DOCTYPE found", "no DOCTYPE", "remove it: entities are not expanded here");
    else if (node != root())
      fail(node, fmt::format("<{}> after the end of <{}>", node.name(), root().name()),
           "one outermost element", "remove it");
}

std::size_t XmlDocument::line_at(std::size_t offset) const {
  const auto before = text_.substr(0, std::min(offset, text_.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::size_t XmlDocument::line(pugi::xml_node at) const {
  return line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(at.offset_debug(), 0)));
}

Place XmlDocument::place(pugi::xml_node at) const {
  return {file_, line(at)};
}

void XmlDocument::fail_at(std::size_t offset, std::string found, std::string expected,
                          std::string remedy) const {
  throw InputError({file_, line_at(offset)}, std::move(found), std::move(expected), std::move(remedy));
}

void XmlDocument::fail(pugi::xml_node at, std::string found, std::string expected, std::string remedy) const {
  throw InputError(place(at), std::move(found), std::move(expected), std::move(remedy));
}

std::vector<pugi::xml_node> XmlDocument::elements(pugi::xml_node parent) const {
  for (const pugi::xml_node child : parent.children())
    if (child.type() != pugi::node_element)
      fail(child, fmt::format("text {} in <{}>", excerpt(child.value()), parent.name()), "elements only",
           "remove it");
  return {parent.begin(), parent.end()};
}

void XmlDocument::allow_elements(pugi::xml_node parent, std::initializer_list<std::string_view> names) const {
  for (const pugi::xml_node child : elements(parent))
    if (!contains(names, child.name()))
      fail(child, fmt::format("unknown element <{}> in <{}>", child.name(), parent.name()),
           names.size() > 0 ? listed(names) : "none", "remove or rename it");
}

pugi::xml_node XmlDocument::at_most_one(pugi::xml_node parent, const char* name) const {
  const pugi::xml_node first = parent.child(name);
  if (const pugi::xml_node second = first.next_sibling(name))
    fail(second, fmt::format("a second <{}> in <{}>", name, parent.name()), "one", "remove it");
  return first;
}

pugi::xml_node XmlDocument::only(pugi::xml_node parent, const char* name) const {
  const pugi::xml_node found = at_most_one(parent, name);
  if (!found) fail(parent, fmt::format("<{}> without <{}>", parent.name(), name), "one", "add it");
  return found;
}

std::string XmlDocument::text(pugi::xml_node parent) const {
  std::string whole;
  for (const pugi::xml_node child : parent.children()) {
    if (child.type() == pugi::node_element)
      fail(child, fmt::format("element <{}> in <{}>", child.name(), parent.name()), "text only", "remove it");
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
      fail(at, fmt::format("a control character in attribute '{}' of <{}>", attribute.name(), at.name()),
           "text", "remove it");
    if (!contains(but, attribute.name())) kept.push_back({attribute.name(), attribute.value()});
  }
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    fail(at, fmt::format("attribute '{}' twice in <{}>", *twice, at.name()), "once", "remove one");
  return kept;
}

void XmlDocument::allow_attributes(pugi::xml_node at, std::initializer_list<std::string_view> names) const {
  if (const Attributes others = attributes(at, names); !others.empty())
    fail(at, fmt::format("unknown attribute '{}' of <{}>", others.front().name, at.name()),
         names.size() > 0 ? listed(names) : "none", "remove or rename it");
}

std::string_view XmlDocument::value(pugi::xml_node at, const char* name) const {
  const pugi::xml_attribute attribute = at.attribute(name);
  if (!attribute) fail(at, fmt::format("<{}> without attribute '{}'", at.name(), name), "one", "add it");
  return attribute.value();
}

double XmlDocument::number(pugi::xml_node at, const char* name) const {
  const auto number = finite_number(value(at, name));
  if (!number)
    fail(at, fmt::format("{}={} in <{}>", name, excerpt(value(at, name)), at.name()), "a finite number",
         "correct it");
  return *number;
}

std::size_t XmlDocument::index(pugi::xml_node at, const char* name) const {
  const auto number = whole_number(value(at, name));
  if (!number)
    fail(at, fmt::format("{}={} in <{}>", name, excerpt(value(at, name)), at.name()),
         fmt::format("a whole number of 0 to {}", largest_index), "correct it");
  return *number;
}

}  // namespace trunk::pml
