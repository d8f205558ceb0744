#include <fmt/format.h>

#include <algorithm>

#include "scenarios/keys.hpp"
#include "scenarios/loads.hpp"
#include "scenarios/read_scenario.hpp"
#include "scenarios/rigid_parts.hpp"

namespace trunk {
namespace {

std::string to_toml(const RegionLoad& load) {
  const auto keys = load_keys();
  const auto& key =
      *std::find_if(keys.begin(), keys.end(), [&](const LoadKey& k) { return k.kind == load.kind; });
  std::string text = fmt::format("\n[[{}]]\nregion = {}\n", key.table, toml_text(load.region));
  if (load.kind != RegionLoad::Kind::pressure || dot(load.direction, load.direction) > 0.0)
    text += "direction = " + toml_direction(load.direction) + "\n";
  if (load.kind == RegionLoad::Kind::displacement) text += "axes = " + toml_direction(load.axes) + "\n";
  return text + fmt::format("{} = {}\n", key.events, toml_events(load.magnitude, key.to_si));
}

}  // namespace

std::string to_toml(const Scenario& s) {
  std::string text = "schema = \"trunk.scenario/1\"\n";
  std::string tables, open_table;
  for (const ScenarioKey& key : scenario_keys()) {
    if (key.left_out && key.left_out(s)) continue;
    const auto dot = key.path.find('.');
    if (dot == std::string_view::npos) {
      text += fmt::format("{} = {}\n", key.path, toml_value(key, s));
      continue;
    }
    const std::string table(key.path.substr(0, dot));
    if (table != open_table) tables += fmt::format("\n[{}]\n", table);
    open_table = table;
    tables += fmt::format("{} = {}\n", key.path.substr(dot + 1), toml_value(key, s));
  }
  if (dot(s.gravity, s.gravity) > 0.0) text += "gravity_m_s2 = " + toml_direction(s.gravity) + "\n";
  if (!s.abdominal_volume.empty())
    text += "abdominal_volume_fraction = " + toml_events(s.abdominal_volume, 1.0) + "\n";
  for (const RegionLoad& load : s.loads) tables += to_toml(load);
  for (const RigidPart& part : s.rigid) tables += to_toml(part);
  return text + tables;
}

}  // namespace trunk
