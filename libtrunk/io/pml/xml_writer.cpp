#include "pml/xml_writer.hpp"

#include <fmt/format.h>

namespace trunk::pml {
namespace {

class TextWriter : public pugi::xml_writer {
 public:
  void write(const void* data, std::size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
  std::string text;
};

}  // namespace

std::string shortest(double value) {
  return fmt::format("{}", value);
}

pugi::xml_node add(pugi::xml_node parent, const char* element) {
  return parent.append_child(element);
}

void add_attribute(pugi::xml_node to, const std::string& name, const std::string& value) {
  to.append_attribute(name.c_str()).set_value(value.c_str());
}

void add_attributes(pugi::xml_node to, const Attributes& attributes) {
  for (const Attribute& attribute : attributes) add_attribute(to, attribute.name, attribute.value);
}

void declare(pugi::xml_document& document) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  add_attributes(declaration, {{"version", "1.0"}, {"encoding", "UTF-8"}});
}

std::string text_of(const pugi::xml_document& document) {
  TextWriter writer;
  document.save(writer, "", pugi::format_indent, pugi::encoding_utf8);
  return std::move(writer.text);
}

}  // namespace trunk::pml
