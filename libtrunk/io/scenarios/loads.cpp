#include "scenarios/loads.hpp"

#include <fmt/format.h>

#include "math/units.hpp"
#include "scenarios/rigid_parts.hpp"
#include "trunks/region_loads_lml.hpp"

namespace trunk {
namespace {

constexpr std::string_view schema = "trunk.scenario/1";

Vec3d without_magnitude(const Vec3d& d) {
  const auto mark = [](double a) { return a != 0.0 ? 1.0 : 0.0; };
  return {mark(d.x()), mark(d.y()), mark(d.z())};
}

RegionLoad load_of(const toml::table& table, const LoadKey& keys, const Place& place) {
  const bool must_point = keys.kind != RegionLoad::Kind::pressure;
  const bool needs_direction = must_point && keys.kind != RegionLoad::Kind::displacement;  // it may hold
  const std::string kind(keys.table);
  RegionLoad load;
  load.kind = keys.kind;
  load.at = place;
  bool has_axes = false;
  const auto read_key = [&](const std::string& key, const toml::node& value, const Place& at) {
    if (key == "region" && value.is_string()) {
      load.region = *value.value_exact<std::string>();
    } else if (key == "direction") {
      load.direction = direction_of(value, kind + ".direction", at);
      if (needs_direction && dot(load.direction, load.direction) == 0.0)
        throw InputError(at, fmt::format("{}.direction is zero", kind), "a direction that is not zero");
    } else if (key == "axes" && keys.kind == RegionLoad::Kind::displacement) {
      load.axes = without_magnitude(direction_of(value, kind + ".axes", at));
      has_axes = true;
    } else if (key == keys.events) {
      load.magnitude = events_of(value, kind + "." + key, keys.to_si, 0.0, at);
    } else {
      throw InputError(at, fmt::format("unknown or wrong key '{}' in [[{}]]", key, kind),
                       fmt::format("region (a text), direction and {}", keys.events));
    }
  };
  for_each_key(table, place, read_key);
  if (!has_axes) load.axes = without_magnitude(load.direction);
  const Vec3d& acts_along = load.kind == RegionLoad::Kind::displacement ? load.axes : load.direction;
  const bool idle = must_point && dot(acts_along, acts_along) == 0.0;
  if (load.region.empty() || load.magnitude.empty() || idle)
    throw InputError(
        place, fmt::format("[[{}]] is incomplete", kind),
        fmt::format("region{} and {}", must_point ? ", a direction that is not zero" : "", keys.events));
  return load;
}

}  // namespace

std::span<const LoadKey> load_keys() {
  static constexpr LoadKey keys[] = {{RegionLoad::Kind::force, "force", "events_N", 1.0},
                                     {RegionLoad::Kind::displacement, "displacement", "events_mm", m_per_mm},
                                     {RegionLoad::Kind::acceleration, "acceleration", "events_m_s2", 1.0},
                                     {RegionLoad::Kind::pressure, "pressure", "events_cmH2O", Pa_per_cmH2O}};
  return keys;
}

bool read_special(const std::string& path, const toml::node& node, const Place& place, Scenario& scenario) {
  if (path == "extends") return true;
  if (path == "schema") {
    if (node.value_exact<std::string>() != schema)
      throw InputError(place, fmt::format("schema is {}", shown(node)), fmt::format("\"{}\"", schema));
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
        throw InputError(place, fmt::format("{} is {}", path, event.value),
                         "0.1 to 10 times the rest volume");
    return true;
  }
  if (path == "loads") {
    const auto name = node.value_exact<std::string>();
    if (!name) throw InputError(place, fmt::format("loads is {}", shown(node)), "the name of an LML file");
    try {
      const auto loads = read_region_loads(beside(place, *name));
      scenario.loads.insert(scenario.loads.end(), loads.begin(), loads.end());
    } catch (const InputError& error) {
      rethrow_named_in(place, error);
    }
    return true;
  }
  if (path == "rigid") {
    for_each_table(path, node, place, [&](const toml::table& table, const Place& at) {
      scenario.rigid.push_back(rigid_part_of(table, at));
    });
    return true;
  }
  for (const LoadKey& keys : load_keys())
    if (path == keys.table) {
      for_each_table(path, node, place, [&](const toml::table& table, const Place& at) {
        scenario.loads.push_back(load_of(table, keys, at));
      });
      return true;
    }
  return false;
}

}  // namespace trunk
