#include "pml/write_lml.hpp"

#include "errors/input_error.hpp"
#include "pml/load_vocabulary.hpp"
#include "pml/read_lml.hpp"
#include "pml/xml_names.hpp"
#include "pml/xml_writer.hpp"

namespace trunk::pml {
namespace {

constexpr const char* written_lml = "LML to be written";

void add_text(pugi::xml_node to, const char* element, const std::string& text) {
  add(to, element).append_child(pugi::node_pcdata).set_value(text.c_str());
}

void add_axis(pugi::xml_node to, const char* name, const Axis& axis) {
  if (axis.kind == Axis::Kind::fixed) add_attribute(to, name, "NULL");
  if (axis.kind == Axis::Kind::along) add_attribute(to, name, shortest(axis.factor));
}

void add_direction(pugi::xml_node to, const Axes& axes) {
  add_axis(to, "x", axes[0]);
  add_axis(to, "y", axes[1]);
  add_axis(to, "z", axes[2]);
}

void add_direction(pugi::xml_node to, const Toward& toward) {
  add_attribute(to, "toward", std::to_string(toward.atom));
}

void add_load(pugi::xml_node to, const Load& load) {
  const pugi::xml_node element = add(to, "load");
  add_attribute(element, "xsi:type", std::string(name_of(load.type)));
  add_attributes(element, load.attributes);
  add_text(element, "appliedTo", text_of(load.targets));
  for (const Load::Event& event : load.events)
    add_attributes(add(element, "valueEvent"),
                   {{"date", shortest(event.date)}, {"value", shortest(event.value)}});
  const pugi::xml_node direction = add(element, "direction");
  std::visit([&](const auto& known) { add_direction(direction, known); }, load.direction);
  if (!load.unit.empty()) add_text(element, "unit", load.unit);
}

std::string text_of_loads(const Loads& loads) {
  pugi::xml_document document;
  declare(document);
  const pugi::xml_node root = add(document, "loads");
  add_attribute(root, "xmlns", std::string(load_namespace));
  add_attribute(root, "xmlns:xsi", std::string(schema_namespace));
  add_attributes(root, loads.attributes);
  for (const Load& load : loads.loads) add_load(root, load);
  return text_of(document);
}

}  // namespace

std::string write_lml(const Loads& loads) {
  std::string text = text_of_loads(loads);
  if (read_lml(text, written_lml) != loads)
    throw InputError({written_lml}, "the loads would read back changed", "names and values that LML keeps",
                     "look for commas in names of components");
  return text;
}

}  // namespace trunk::pml
