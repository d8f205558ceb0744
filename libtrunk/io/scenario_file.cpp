#include "io/scenario_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "errors/input_error.hpp"
#include "io/scenario_keys.hpp"
#include "io/text_file.hpp"

namespace trunk {
namespace {

constexpr std::string_view schema = "trunk.scenario/1";
constexpr std::size_t largest_file = 10'000'000;

struct Place {
  std::string file;
  std::size_t line;
  [[noreturn]] void fail(const std::string& text) const { throw InputError(file, line, text); }
  std::string name() const { return line > 0 ? fmt::format("{}:{}", file, line) : file; }
};

std::string shown(const toml::node& node) {
  std::ostringstream out;
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  node.visit([&](const auto& value) { out << value; });
  std::string text = out.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

toml::table parse(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(file, error.source().begin.line,
                     fmt::format("not valid TOML: {}", std::string(error.description())));
  }
}

const ScenarioKey* find_key(const std::string& path) {
  for (const ScenarioKey& key : scenario_keys())
    if (key.path == path) return &key;
  return nullptr;
}

double number_of(const toml::node& node, const std::string& what, const std::string& expected,
                 const Place& place) {
  const auto value = node.value<double>();
  if (!value || node.is_boolean() || node.is_string())
    place.fail(fmt::format("{} is {}, expected {}", what, shown(node), expected));
  if (!std::isfinite(*value)) place.fail(fmt::format("{} is not finite, expected {}", what, expected));
  return *value;
}

struct Assign {
  Scenario& scenario;
  const ScenarioKey& key;
  const toml::node& node;
  const Place& place;

  [[noreturn]] void wrong() const {
    place.fail(fmt::format("{} is {}, expected {}", key.path, shown(node), expectation(key)));
  }
  void operator()(const ScenarioKey::Number& n) const {
    const double value = number_of(node, std::string(key.path), expectation(key), place);
    if (!(value >= n.low && value <= n.high)) wrong();
    n.field(scenario) = value * n.to_si;
  }
  void operator()(const ScenarioKey::Choice& c) const {
    const auto name = node.value_exact<std::string>();
    const auto at = name ? std::find(c.names.begin(), c.names.end(), *name) : c.names.end();
    if (at == c.names.end()) wrong();
    c.set(scenario, static_cast<int>(at - c.names.begin()));
  }
  void operator()(const ScenarioKey::Switch& b) const {
    const auto value = node.value_exact<bool>();
    if (!value) wrong();
    b.field(scenario) = *value;
  }
  void operator()(const ScenarioKey::Text& t) const {
    const auto value = node.value_exact<std::string>();
    if (!value) wrong();
    t.field(scenario) = *value;
  }
};

[[noreturn]] void unknown_key(const std::string& path, const Place& place) {
  const std::string near = nearest_key(path);
  const ScenarioKey* key = find_key(near);
  place.fail(fmt::format("unknown key '{}'{}; `trunk check --keys` lists all keys", path,
                         key ? fmt::format(", expected '{}' ({})", key->path, expectation(*key)) : ""));
}

PiecewiseLinear read_events(const toml::node& node, const std::string& what, double to_si, double before,
                            const Place& place) {
  const std::string expected = "a list of [time in s, value] pairs, times increasing";
  const toml::array* list = node.as_array();
  if (!list || list->empty()) place.fail(fmt::format("{} is {}, expected {}", what, shown(node), expected));
  std::vector<PiecewiseLinear::Event> events;
  for (const toml::node& item : *list) {
    const toml::array* pair = item.as_array();
    if (!pair || pair->size() != 2)
      place.fail(fmt::format("{} has {}, expected {}", what, shown(item), expected));
    events.push_back({number_of(*pair->get(0), what, expected, place),
                      to_si * number_of(*pair->get(1), what, expected, place)});
  }
  try {
    return PiecewiseLinear(std::move(events), before);
  } catch (const InputError& error) {
    place.fail(fmt::format("{}: {}", what, error.what()));
  }
}

Vec3d read_direction(const toml::node& node, const std::string& what, const Place& place) {
  const std::string expected = "three numbers [right, forward, up]";
  const toml::array* list = node.as_array();
  if (!list || list->size() != 3)
    place.fail(fmt::format("{} is {}, expected {}", what, shown(node), expected));
  const auto at = [&](std::size_t i) { return number_of(*list->get(i), what, expected, place); };
  return {at(0), at(1), at(2)};
}

class Reader {
 public:
  explicit Reader(ScenarioFile& file) : file_(file) {}

  void read(const std::filesystem::path& path, int depth) {
    const std::string name = path.string();
    const std::string text = read_text_file(path, largest_file);
    if (depth == 0) file_.text = text;
    file_.inputs.push_back(path);
    const toml::table root = parse(text, name);
    if (const toml::node* base = root.get("extends")) {
      const Place place{name, base->source().begin.line};
      const auto target = base->value_exact<std::string>();
      if (!target) place.fail("extends is " + shown(*base) + ", expected the name of a scenario file");
      if (depth >= 8) place.fail("extends goes more than 8 files deep; does a file extend itself?");
      const auto parent = path.parent_path() / *target;
      std::error_code ignored;
      if (!std::filesystem::exists(parent, ignored))
        place.fail(
            fmt::format("extends {}: no such file, expected the name of a scenario file", parent.string()));
      read(parent, depth + 1);
    }
    read_table(root, "", name);
  }

  void set(const Setting& setting) {
    const Place place{setting.where, 0};
    const std::string &path = setting.key, &text = setting.value;
    const ScenarioKey* key = find_key(path);
    if (!key) unknown_key(path, place);
    const bool plain = std::holds_alternative<ScenarioKey::Choice>(key->kind) ||
                       std::holds_alternative<ScenarioKey::Text>(key->kind);
    toml::table table;
    if (plain)
      table.insert("value", text);
    else
      try {
        table = toml::parse("value = " + text);
        if (table.size() != 1)
          place.fail(fmt::format("{} is '{}', expected {}", path, text, expectation(*key)));
      } catch (const toml::parse_error&) {
        place.fail(fmt::format("{} is '{}', expected {}", path, text, expectation(*key)));
      }
    assign(*key, *table.get("value"), place);
  }

 private:
  void assign(const ScenarioKey& key, const toml::node& node, const Place& place) {
    std::visit(Assign{file_.scenario, key, node, place}, key.kind);
    file_.origin[std::string(key.path)] = place.name();
  }

  void read_table(const toml::table& table, const std::string& prefix, const std::string& name) {
    for (const auto& [key_text, node] : table) {
      const std::string path = prefix + std::string(key_text.str());
      const Place place{name, key_text.source().begin.line};
      if (const ScenarioKey* key = find_key(path))
        assign(*key, node, place);
      else if (!read_special(path, node, place))
        descend(path, node, place);
    }
  }

  void descend(const std::string& path, const toml::node& node, const Place& place) {
    const bool is_table = std::any_of(scenario_keys().begin(), scenario_keys().end(),
                                      [&](const ScenarioKey& k) { return k.path.starts_with(path + "."); });
    if (!is_table || !node.is_table()) unknown_key(path, place);
    read_table(*node.as_table(), path + ".", place.file);
  }

  bool read_special(const std::string& path, const toml::node& node, const Place& place) {
    if (path == "extends") return true;
    if (path == "schema") {
      if (node.value_exact<std::string>() != schema)
        place.fail(fmt::format("schema is {}, expected \"{}\"", shown(node), schema));
      return true;
    }
    Scenario& s = file_.scenario;
    if (path == "gravity_m_s2") {
      s.gravity = read_direction(node, path, place);
      return true;
    }
    if (path == "abdominal_volume_fraction") {
      s.abdominal_volume = read_events(node, path, 1.0, 1.0, place);
      for (const auto& event : s.abdominal_volume.events())
        if (!(event.value > 0.1 && event.value < 10.0))
          place.fail(fmt::format("{} is {}, expected 0.1 to 10 times the rest volume", path, event.value));
      return true;
    }
    if (path == "force" || path == "displacement") {
      read_loads(path, node, place);
      return true;
    }
    return false;
  }

  void read_loads(const std::string& path, const toml::node& node, const Place& place) {
    const toml::array* list = node.as_array();
    if (!list || !list->is_array_of_tables()) place.fail(fmt::format("expected [[{}]] tables", path));
    const bool is_force = path == "force";
    const std::string events_key = is_force ? "events_N" : "events_mm";
    for (const toml::node& item : *list) {
      const toml::table& table = *item.as_table();
      RegionLoad load;
      load.kind = is_force ? RegionLoad::Kind::force : RegionLoad::Kind::displacement;
      load.origin = Place{place.file, item.source().begin.line}.name();
      for (const auto& [key_text, value] : table) {
        const std::string key(key_text.str());
        const Place at{place.file, key_text.source().begin.line};
        if (key == "region" && value.is_string())
          load.region = *value.value_exact<std::string>();
        else if (key == "direction") {
          load.direction = read_direction(value, path + ".direction", at);
          if (dot(load.direction, load.direction) == 0.0)
            at.fail(path + ".direction is zero, expected a direction");
        } else if (key == events_key)
          load.magnitude = read_events(value, path + "." + key, is_force ? 1.0 : 1e-3, 0.0, at);
        else
          at.fail(
              fmt::format("unknown or wrong key '{}' in [[{}]], expected region (a text), direction and {}",
                          key, path, events_key));
      }
      if (load.region.empty() || load.magnitude.empty() || dot(load.direction, load.direction) == 0.0)
        throw InputError(fmt::format("{}: [[{}]] is incomplete, expected region, direction and {}",
                                     load.origin, path, events_key));
      file_.scenario.loads.push_back(load);
    }
  }

  ScenarioFile& file_;
};

}  // namespace

std::string ScenarioFile::where(const std::string& key) const {
  const auto at = origin.find(key);
  return at == origin.end() ? path : at->second;
}

ScenarioFile read_scenario(const std::filesystem::path& path, const std::vector<std::string>& settings) {
  ScenarioFile file;
  file.path = path.string();
  Reader(file).read(path, 0);
  apply_settings(settings, file);
  return file;
}

Setting setting_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError("--set " + text + ": expected key=value, as in parameters.k_muscle_N_per_m=30");
  return {text.substr(0, equals), text.substr(equals + 1), "--set " + text};
}

void apply_settings(const std::vector<Setting>& settings, ScenarioFile& file) {
  for (const Setting& setting : settings) Reader(file).set(setting);
}

void apply_settings(const std::vector<std::string>& settings, ScenarioFile& file) {
  for (const std::string& text : settings) Reader(file).set(setting_of(text));
}

Trunk build_trunk(const ScenarioFile& file) {
  const auto at = [](const std::string& where, const InputError& error) {
    return InputError(where, 0, error.what());
  };
  Trunk trunk;
  try {
    trunk = make_trunk(file.scenario);
  } catch (const InputError& error) {
    for (const RegionLoad& load : file.scenario.loads)  // a load names its own line
      if (std::string_view(error.what()).starts_with(load.origin + ": ")) throw;
    throw at(file.path, error);
  }
  try {
    require_stable(file.scenario, trunk);
  } catch (const InputError& error) {
    throw at(file.where("time.dt_ms"), error);
  }
  return trunk;
}

}  // namespace trunk
