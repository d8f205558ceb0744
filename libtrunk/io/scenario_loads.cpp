#include "io/scenario_loads.hpp"

#include <fmt/format.h>

namespace trunk {
namespace {

constexpr std::string_view schema = "trunk.scenario/1";

RegionLoad load_of(const toml::table& table, const std::string& kind, const TomlPlace& place) {
  const bool is_force = kind == "force";
  const std::string events_key = is_force ? "events_N" : "events_mm";
  RegionLoad load;
  load.kind = is_force ? RegionLoad::Kind::force : RegionLoad::Kind::displacement;
  load.origin = place.name();
  for (const auto& [key_text, value] : table) {
    const std::string key(key_text.str());
    const TomlPlace at{place.file, key_text.source().begin.line};
    if (key == "region" && value.is_string()) {
      load.region = *value.value_exact<std::string>();
    } else if (key == "direction") {
      load.direction = direction_of(value, kind + ".direction", at);
      if (dot(load.direction, load.direction) == 0.0)
        at.fail(kind + ".direction is zero, expected a direction");
    } else if (key == events_key) {
      load.magnitude = events_of(value, kind + "." + key, is_force ? 1.0 : 1e-3, 0.0, at);
    } else {
      at.fail(fmt::format("unknown or wrong key '{}' in [[{}]], expected region (a text), direction and {}",
                          key, kind, events_key));
    }
  }
  if (load.region.empty() || load.magnitude.empty() || dot(load.direction, load.direction) == 0.0)
    place.fail(fmt::format("[[{}]] is incomplete, expected region, direction and {}", kind, events_key));
  return load;
}

void read_loads(const std::string& kind, const toml::node& node, const TomlPlace& place, Scenario& scenario) {
  const toml::array* list = node.as_array();
  if (!list || !list->is_array_of_tables()) place.fail(fmt::format("expected [[{}]] tables", kind));
  for (const toml::node& item : *list)
    scenario.loads.push_back(load_of(*item.as_table(), kind, {place.file, item.source().begin.line}));
}

}  // namespace

bool read_special(const std::string& path, const toml::node& node, const TomlPlace& place,
                  Scenario& scenario) {
  if (path == "extends") return true;
  if (path == "schema") {
    if (node.value_exact<std::string>() != schema)
      place.fail(fmt::format("schema is {}, expected \"{}\"", shown(node), schema));
    return true;
  }
  if (path == "gravity_m_s2") {
    scenario.gravity = direction_of(node, path, place);
    return true;
  }
  if (path == "abdominal_volume_fraction") {
    scenario.abdominal_volume = events_of(node, path, 1.0, 1.0, place);
    for (const auto& event : scenario.abdominal_volume.events())
      if (!(event.value > 0.1 && event.value < 10.0))
        place.fail(fmt::format("{} is {}, expected 0.1 to 10 times the rest volume", path, event.value));
    return true;
  }
  if (path == "force" || path == "displacement") {
    read_loads(path, node, place, scenario);
    return true;
  }
  return false;
}

}  // namespace trunk
