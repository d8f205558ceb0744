#include "pml/read_lml.hpp"

#include <fmt/format.h>

#include "pml/applied_to.hpp"
#include "pml/load_vocabulary.hpp"
#include "pml/text_values.hpp"
#include "pml/xml_names.hpp"
#include "text/message_text.hpp"

namespace trunk::pml {
namespace {

// The elements of a load, before they are read.
struct Parts {
  pugi::xml_node applied_to, direction, unit;
  std::vector<pugi::xml_node> events;
};

void take_once(const XmlDocument& xml, pugi::xml_node& place, pugi::xml_node element) {
  if (place) xml.fail(element, fmt::format("a second <{}> in a load", element.name()), "one", "remove it");
  place = element;
}

Parts parts_of(const XmlDocument& xml, pugi::xml_node load) {
  Parts parts;
  for (const pugi::xml_node element : xml.elements(load)) {
    const std::string_view name = load_name(xml, element);
    if (name == "appliedTo") {
      take_once(xml, parts.applied_to, element);
    } else if (name == "valueEvent") {
      parts.events.push_back(element);
    } else if (name == "direction") {
      take_once(xml, parts.direction, element);
    } else if (name == "unit") {
      take_once(xml, parts.unit, element);
    } else {
      xml.fail(element, fmt::format("unknown element <{}> in a load", element.name()),
               "appliedTo, valueEvent, direction, unit", "remove or rename it");
    }
  }
  return parts;
}

void check_complete(const XmlDocument& xml, pugi::xml_node load, const Parts& parts) {
  const char* const missing = !parts.applied_to      ? "appliedTo"
                              : parts.events.empty() ? "valueEvent"
                              : !parts.direction     ? "direction"
                                                     : nullptr;
  if (missing) xml.fail(load, fmt::format("load without <{}>", missing), "one", "add it");
}

bool is_type(const XmlDocument& xml, pugi::xml_node load, std::string_view attribute) {
  return qualified(xml, load, attribute, false) == QualifiedName{schema_namespace, "type"};
}

Load::Type type_of(const XmlDocument& xml, pugi::xml_node load) {
  for (const pugi::xml_attribute attribute : load.attributes()) {
    if (declares_namespace(attribute.name()) || !is_type(xml, load, attribute.name())) continue;
    const auto type = load_type(qualified(xml, load, trimmed(attribute.value()), true).local);
    if (type) return *type;
    xml.fail(load, fmt::format("load of unknown type {}", excerpt(attribute.value())), load_type_names(),
             "correct it");
  }
  xml.fail(load, "load without xsi:type", fmt::format("one of {}", load_type_names()), "add it");
}

// Returns the attributes without declarations and without those of the schema.
Attributes own_attributes(const XmlDocument& xml, pugi::xml_node element) {
  Attributes own = xml.attributes(element);
  std::erase_if(own, [&](const Attribute& attribute) {
    return declares_namespace(attribute.name) ||
           qualified(xml, element, attribute.name, false).space == schema_namespace;
  });
  for (const Attribute& attribute : own)
    if (attribute.name.find(':') != std::string::npos && !attribute.name.starts_with("xml:"))
      xml.fail(element,
               fmt::format("attribute '{}' of another namespace in <{}>", attribute.name, element.name()),
               "none", "remove it");
  return own;
}

std::vector<Load::Event> events_of(const XmlDocument& xml, const std::vector<pugi::xml_node>& elements) {
  std::vector<Load::Event> events;
  for (const pugi::xml_node element : elements) {
    xml.allow_elements(element, {});
    xml.allow_attributes(element, {"date", "value"});
    const Load::Event event{xml.number(element, "date"), xml.number(element, "value")};
    if (!events.empty() && !(events.back().date < event.date))
      xml.fail(element, fmt::format("date {} after date {}", event.date, events.back().date),
               "increasing dates", "sort the valueEvents");
    events.push_back(event);
  }
  return events;
}

Axis axis_of(const XmlDocument& xml, pugi::xml_node direction, const char* name) {
  if (!direction.attribute(name)) return {};
  const std::string_view value = xml.value(direction, name);
  if (trimmed(value) == "NULL") return {Axis::Kind::fixed, 0.0};
  const auto number = finite_number(value);
  if (!number)
    xml.fail(direction, fmt::format("{}={} in <direction>", name, excerpt(value)),
             fmt::format("a finite number, NULL (held), or no {} (free)", name), "correct it");
  return {Axis::Kind::along, *number};
}

std::variant<Axes, Toward> direction_of(const XmlDocument& xml, pugi::xml_node direction) {
  xml.allow_elements(direction, {});
  xml.allow_attributes(direction, {"x", "y", "z", "toward"});
  const Axes axes{axis_of(xml, direction, "x"), axis_of(xml, direction, "y"), axis_of(xml, direction, "z")};
  const bool has_toward = direction.attribute("toward"), has_axes = axes != Axes{};
  if (has_toward == has_axes)
    xml.fail(
        direction,
        fmt::format("<direction> with {}", has_axes ? "both axes and toward" : "neither axes nor toward"),
        "either x, y, z or toward", "correct it");
  if (has_toward) return Toward{xml.index(direction, "toward")};
  return axes;
}

std::string unit_of(const XmlDocument& xml, pugi::xml_node unit, pugi::xml_node load, Load::Type type) {
  xml.allow_attributes(unit, {});
  std::string name = xml.text(unit);
  if (!si_factor(type, name))
    xml.fail(unit ? unit : load, fmt::format("{} in unit {}", name_of(type), excerpt(name)), unit_names(type),
             "correct it");
  return name;
}

Load read_load(const XmlDocument& xml, pugi::xml_node node) {
  const Parts parts = parts_of(xml, node);
  Load load;
  load.line = xml.line(node);
  load.attributes = own_attributes(xml, node);
  load.type = type_of(xml, node);
  check_complete(xml, node, parts);
  xml.allow_attributes(parts.applied_to, {});
  load.targets = read_load_targets(xml, parts.applied_to);
  load.events = events_of(xml, parts.events);
  load.direction = direction_of(xml, parts.direction);
  load.unit = unit_of(xml, parts.unit, node, load.type);
  return load;
}

}  // namespace

Loads read_lml(std::string_view text, const std::string& file) {
  const XmlDocument xml(text, file, "LML");
  if (load_name(xml, xml.root()) != "loads")
    xml.fail(xml.root(), fmt::format("<{}> found", xml.root().name()), "<loads>", "give an LML file");
  Loads loads;
  loads.attributes = own_attributes(xml, xml.root());
  for (const pugi::xml_node element : xml.elements(xml.root())) {
    if (load_name(xml, element) != "load")
      xml.fail(element, fmt::format("unknown element <{}>", element.name()), "<load>", "remove or rename it");
    loads.loads.push_back(read_load(xml, element));
  }
  return loads;
}

}  // namespace trunk::pml
