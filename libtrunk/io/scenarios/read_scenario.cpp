#include "scenarios/read_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "files/read_file.hpp"
#include "scenarios/keys.hpp"
#include "scenarios/loads.hpp"
#include "scenarios/scenario_trunk.hpp"
#include "scenarios/toml_values.hpp"

namespace trunk {
namespace {

constexpr std::size_t largest_scenario = 10'000'000;

const ScenarioKey* find_key(const std::string& path) {
  for (const ScenarioKey& key : scenario_keys())
    if (key.path == path) return &key;
  return nullptr;
}

struct Assign {
  Scenario& scenario;
  const ScenarioKey& key;
  const toml::node& node;
  const Place& place;

  [[noreturn]] void wrong() const {
    throw InputError(place, fmt::format("{} is {}", key.path, shown(node)), expectation(key));
  }
  void operator()(const ScenarioKey::Number& n) const {
    const bool open = n.automatic && node.value_exact<std::string>() == "auto";
    if (n.automatic) n.automatic(scenario) = open;
    if (open) return;
    const double value = number_of(node, std::string(key.path), expectation(key), place);
    if (!(value >= n.low && value <= n.high)) wrong();
    n.field(scenario) = value * n.to_si;
  }
  void operator()(const ScenarioKey::Course& c) const {
    if (node.is_array()) {
      c.field(scenario) = events_of(node, std::string(key.path), c.to_si, 0.0, place);
    } else {
      const double value = c.to_si * number_of(node, std::string(key.path), expectation(key), place);
      c.field(scenario) = PiecewiseLinear({{0.0, value}}, value);
    }
    for (const auto& event : c.field(scenario).events())
      if (!(event.value >= c.low * c.to_si && event.value <= c.high * c.to_si)) wrong();
  }
  void operator()(const ScenarioKey::Integer& i) const {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < i.low || *value > i.high) wrong();
    i.field(scenario) = static_cast<int>(*value);
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
  void operator()(const ScenarioKey::File& f) const {
    const auto value = node.value_exact<std::string>();
    if (!value) wrong();
    f.field(scenario) = value->empty() || *value == "\"\"" ? "" : beside(place, *value).string();
  }
};

[[noreturn]] void unknown_key(const std::string& path, const Place& place) {
  const std::string near = nearest_key(path);
  const ScenarioKey* key = find_key(near);
  throw InputError(place, fmt::format("unknown key '{}'", path),
                   key ? fmt::format("'{}' ({})", key->path, expectation(*key)) : "",
                   "`trunk check --keys` lists all keys");
}

/// Continues after a mistake, and gathers all of them for the caller.
class Reader {
 public:
  Reader(ScenarioFile& file, Mistakes& mistakes) : file_(file), mistakes_(mistakes) {}

  void read(const std::filesystem::path& path, int depth) {
    const std::string text = read_text_file(path, largest_scenario);
    if (depth == 0) file_.text = text;
    file_.inputs.push_back(path);
    read_text(text, path, depth);
  }

  void read_text(const std::string& text, const std::filesystem::path& path, int depth) {
    const std::string name = path.string();
    const toml::table root = parse_toml(text, name);
    if (const toml::node* base = root.get("extends"))
      mistakes_.gather([&] { read_extended(*base, path, depth); });
    read_table(root, "", name);
  }

  void set(const Setting& setting) {
    const Place& place = setting.at;
    const std::string &path = setting.key, &text = setting.value;
    const ScenarioKey* key = find_key(path);
    if (!key) unknown_key(path, place);
    const auto* number = std::get_if<ScenarioKey::Number>(&key->kind);
    const bool plain = (number && number->automatic && text == "auto") ||
                       std::holds_alternative<ScenarioKey::Choice>(key->kind) ||
                       std::holds_alternative<ScenarioKey::Text>(key->kind) ||
                       std::holds_alternative<ScenarioKey::File>(key->kind);
    toml::table table;
    if (plain)
      table.insert("value", text);
    else
      try {
        table = toml::parse("value = " + text);
        if (table.size() != 1)
          throw InputError(place, fmt::format("{} is '{}'", path, text), expectation(*key));
      } catch (const toml::parse_error&) {
        throw InputError(place, fmt::format("{} is '{}'", path, text), expectation(*key));
      }
    assign(*key, *table.get("value"), place);
    file_.settings.insert(path);
  }

 private:
  void read_extended(const toml::node& base, const std::filesystem::path& path, int depth) {
    const Place place{path.string(), base.source().begin.line};
    const auto named = base.value_exact<std::string>();
    if (!named)
      throw InputError(place, fmt::format("extends is {}", shown(base)), "the name of a scenario file");
    if (depth >= 8)
      throw InputError(place, "extends goes more than 8 files deep", "",
                       "check whether a file extends itself");
    const auto parent = path.parent_path() / *named;
    std::error_code ignored;
    if (!std::filesystem::exists(parent, ignored))
      throw InputError(place, fmt::format("extends {}: no such file", parent.string()),
                       "the name of a scenario file");
    read(parent, depth + 1);
  }

  void assign(const ScenarioKey& key, const toml::node& node, const Place& place) {
    std::visit(Assign{file_.scenario, key, node, place}, key.kind);
    if (key.when_read) key.when_read(file_.scenario);
    file_.origin[std::string(key.path)] = place;
  }

  void read_table(const toml::table& table, const std::string& prefix, const std::string& name) {
    for (const auto& [key, value] : table) {
      const Place place{name, key.source().begin.line};
      mistakes_.gather(
          [&, &k = key, &node = value] { read_key(prefix + std::string(k.str()), node, place); });
    }
  }

  void read_key(const std::string& path, const toml::node& node, const Place& place) {
    if (const ScenarioKey* key = find_key(path))
      assign(*key, node, place);
    else if (!read_special(path, node, place, file_.scenario))
      descend(path, node, place);
    if (path == "loads") file_.inputs.push_back(beside(place, *node.value_exact<std::string>()));
  }

  void descend(const std::string& path, const toml::node& node, const Place& place) {
    const bool is_table = std::any_of(scenario_keys().begin(), scenario_keys().end(),
                                      [&](const ScenarioKey& k) { return k.path.starts_with(path + "."); });
    if (!is_table || !node.is_table()) unknown_key(path, place);
    read_table(*node.as_table(), path + ".", place.file);
  }

  ScenarioFile& file_;
  Mistakes& mistakes_;
};

/// Applies all settings to the scenario, and then reads the trunk that it names.
void put_over(const std::vector<Setting>& settings, ScenarioFile& file, Mistakes& mistakes) {
  for (const Setting& setting : settings) mistakes.gather([&] { Reader(file, mistakes).set(setting); });
  mistakes.settle();
  read_named_trunk(file);
  for (const Setting& setting : settings) mistakes.gather([&] { require_effect(setting, file.scenario); });
  mistakes.settle();
}

std::vector<Setting> settings_of(const std::vector<std::string>& texts, Mistakes& mistakes) {
  std::vector<Setting> settings;
  for (const std::string& text : texts) mistakes.gather([&] { settings.push_back(setting_of(text)); });
  return settings;
}

}  // namespace

Place ScenarioFile::where(const std::string& key) const {
  const auto at = origin.find(key);
  return at == origin.end() ? Place{path} : at->second;
}

ScenarioFile read_scenario(const std::filesystem::path& path, const std::vector<std::string>& settings) {
  ScenarioFile file;
  file.path = path.string();
  Mistakes mistakes;
  mistakes.gather([&] { Reader(file, mistakes).read(path, 0); });
  put_over(settings_of(settings, mistakes), file, mistakes);
  return file;
}

ScenarioFile scenario_of_text(const std::string& text, const std::string& name,
                              const std::string& trunk_pml) {
  ScenarioFile file;
  file.path = name;
  file.text = text;
  Mistakes mistakes;
  mistakes.gather([&] { Reader(file, mistakes).read_text(text, name, 0); });
  mistakes.settle();
  if (!trunk_pml.empty()) adopt_trunk(trunk_of_pml(trunk_pml, name), file);
  read_named_trunk(file);
  return file;
}

Setting setting_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError({"--set " + text}, "no '=' found", "key=value, as in parameters.k_muscle_N_per_m=30");
  return {text.substr(0, equals), text.substr(equals + 1), {"--set " + text}};
}

void apply_settings(const std::vector<Setting>& settings, ScenarioFile& file) {
  Mistakes mistakes;
  put_over(settings, file, mistakes);
}

void apply_settings(const std::vector<std::string>& texts, ScenarioFile& file) {
  Mistakes mistakes;
  put_over(settings_of(texts, mistakes), file, mistakes);
}

}  // namespace trunk
