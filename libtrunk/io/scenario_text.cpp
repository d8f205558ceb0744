#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "errors/input_error.hpp"
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

/// `text` with the value of line `line` (from 1), which reads key = value # comment, replaced.
std::string with_line_value(const std::string& text, std::size_t line, const std::string& value) {
  std::istringstream in(text);
  std::string result, current;
  for (std::size_t n = 1; std::getline(in, current); ++n) {
    if (n == line) {
      const auto equals = current.find('=');
      const auto comment = current.find('#', equals);
      const std::string tail = comment == std::string::npos ? "" : " " + current.substr(comment);
      current = current.substr(0, equals + 1) + " " + value;
      if (!tail.empty() && current.size() + 1 < comment)
        current.resize(comment - 1, ' ');  // comments stay aligned
      current += tail;
    }
    result += current + "\n";
  }
  return result;
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

std::string with_values(const std::filesystem::path& from, const std::vector<std::string>& keys,
                        const Scenario& scenario) {
  const ScenarioFile file = read_scenario(from);
  std::string text = file.text;
  for (const std::string& path : keys) {
    const toml::table root = toml::parse(text);
    const auto node = root.at_path(path);
    if (!node)
      throw InputError(from.string(), 0, "does not set " + path + ", expected it there to be replaced");
    for (const ScenarioKey& key : scenario_keys())
      if (key.path == path)
        text = with_line_value(text, node.node()->source().begin.line, toml_value(key, scenario));
  }
  return text;
}

}  // namespace trunk
