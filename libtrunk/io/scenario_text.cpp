#include <fmt/format.h>
#include "io/scenario_file.hpp"
#include "io/scenario_keys.hpp"

namespace trunk {
namespace {

std::string events_text(const PiecewiseLinear& curve, double to_si) {
  std::string text;
  for (const auto& event : curve.events())
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", event.time_s, event.value / to_si);
  return "[" + text + "]";
}

std::string direction_text(const Vec3d& d) {
  return fmt::format("[{}, {}, {}]", d.x(), d.y(), d.z());
}

}  // namespace

std::string to_toml(const Scenario& s) {
  std::string text = "schema = \"trunk.scenario/1\"\n";
  std::string tables, open_table;
  for (const ScenarioKey& key : scenario_keys()) {
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
  if (dot(s.gravity, s.gravity) > 0.0) text += "gravity_m_s2 = " + direction_text(s.gravity) + "\n";
  if (!s.abdominal_volume.empty())
    text += "abdominal_volume_fraction = " + events_text(s.abdominal_volume, 1.0) + "\n";
  for (const RegionLoad& load : s.loads) {
    const bool is_force = load.kind == RegionLoad::Kind::force;
    tables +=
        fmt::format("\n[[{}]]\nregion = \"{}\"\ndirection = {}\n{} = {}\n",
                    is_force ? "force" : "displacement", load.region, direction_text(load.direction),
                    is_force ? "events_N" : "events_mm", events_text(load.magnitude, is_force ? 1.0 : 1e-3));
  }
  return text + tables;
}

}  // namespace trunk
