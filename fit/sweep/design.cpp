#include "sweep/design.hpp"

#include <fmt/format.h>

#include <cmath>

#include "errors/input_error.hpp"
#include "io/text_file.hpp"
#include "io/toml_values.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_runs = 1'000'000, largest_file = 1'000'000;

struct Reader {
  std::string file;

  [[noreturn]] void fail(const toml::node& at, const std::string& text) const {
    throw InputError(file, at.source().begin.line, text);
  }

  double number(const toml::node* node, const toml::node& parent, const std::string& what) const {
    const auto value = node && node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value))
      fail(node ? *node : parent,
           fmt::format("{}: found {}, expected a finite number", what, node ? shown(*node) : "nothing"));
    return *value;
  }

  std::vector<double> range(const toml::table& t, const std::string& key) const {
    for (const auto& [name, node] : t)
      if (name != "from" && name != "to" && name != "count" && name != "scale")
        fail(node, fmt::format("unknown '{}' in {}, expected from, to, count and scale",
                               std::string(name.str()), key));
    const double from = number(t.get("from"), t, key + ".from"), to = number(t.get("to"), t, key + ".to");
    const double count = number(t.get("count"), t, key + ".count");
    const std::string scale = t["scale"].value_or(std::string("linear"));
    if (count != std::floor(count) || count < 1 || count > static_cast<double>(most_runs))
      fail(t, key + ".count: expected a whole number from 1");
    if (scale != "linear" && scale != "log") fail(t, key + ".scale: expected \"linear\" or \"log\"");
    if (scale == "log" && (from <= 0 || to <= 0)) fail(t, key + ": a log scale needs values above 0");
    std::vector<double> values;
    for (double i = 0; i < count; ++i) {
      const double part = count > 1 ? i / (count - 1) : 0.0;
      values.push_back(scale == "log" ? from * std::pow(to / from, part) : from + part * (to - from));
    }
    return values;
  }

  SweepDesign::Axis axis(const std::string& key, const toml::node& node) const {
    SweepDesign::Axis axis{key, fmt::format("{}:{}", file, node.source().begin.line), {}};
    if (const toml::array* list = node.as_array())
      for (const toml::node& item : *list) axis.values.push_back(number(&item, node, key));
    else if (const toml::table* table = node.as_table())
      axis.values = range(*table, key);
    if (axis.values.empty())
      fail(node, key + ": expected a list of numbers or { from = 1, to = 2, count = 5, scale = \"log\" }");
    return axis;
  }

  void grid(const toml::node& node, SweepDesign& design) const {
    const toml::table* table = node.as_table();
    if (!table)
      fail(node, "grid: expected a table, as in [grid] and \"parameters.k_muscle_N_per_m\" = [20, 30]");
    for (const auto& [key, value] : *table) {
      const std::string name(key.str());
      if (name.find('.') == std::string::npos)
        fail(value,
             fmt::format("grid key '{0}': expected the full name in quotes, as in \"parameters.{0}\"", name));
      design.axes.push_back(axis(name, value));
    }
  }

  void scenarios(const toml::node& node, SweepDesign& design) const {
    const toml::array* list = node.as_array();
    if (!list || list->empty()) fail(node, "scenarios: expected a list of scenario files");
    for (const toml::node& item : *list) {
      const auto name = item.value_exact<std::string>();
      if (!name) fail(item, "scenarios: expected file names in quotes");
      const auto path = std::filesystem::path(file).parent_path() / *name;
      if (!std::filesystem::exists(path))
        fail(item, fmt::format("there is no scenario file {}", path.string()));
      design.scenarios.push_back(path);
    }
  }
};

/// A wrong key or value shows before the first run, not after an hour.
void try_everything(const SweepDesign& design) {
  for (const auto& scenario : design.scenarios) {
    const ScenarioFile file = read_scenario(scenario);
    for (const auto& axis : design.axes)
      for (double value : axis.values) {
        ScenarioFile trial = file;
        apply_settings(std::vector<Setting>{{axis.key, fmt::format("{}", value), axis.where}}, trial);
      }
  }
}

}  // namespace

std::size_t SweepDesign::runs() const noexcept {
  std::size_t count = scenarios.size();
  for (const Axis& axis : axes)
    count = count > most_runs ? count
                              : count * axis.values.size();  // no overflow: each factor is at most most_runs
  return count;
}

const std::filesystem::path& SweepDesign::scenario_of(std::size_t run) const {
  return scenarios[run / (runs() / scenarios.size())];
}

std::vector<double> SweepDesign::values_of(std::size_t run) const {
  std::vector<double> values(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    values[a] = axes[a].values[run % axes[a].values.size()];
    run /= axes[a].values.size();
  }
  return values;
}

std::vector<Setting> SweepDesign::settings_of(std::size_t run) const {
  std::vector<Setting> settings;
  const std::vector<double> values = values_of(run);
  for (std::size_t a = 0; a < axes.size(); ++a)
    settings.push_back({axes[a].key, fmt::format("{}", values[a]), axes[a].where});
  return settings;
}

SweepDesign read_sweep_design(const std::filesystem::path& path) {
  SweepDesign design;
  design.path = path.string();
  design.text = read_text_file(path, largest_file);
  const Reader reader{design.path};
  const toml::table root = parse_toml(design.text, design.path);
  for (const auto& [key, node] : root) {
    if (key == "schema") {
      if (node.value_exact<std::string>() != "trunk.sweep/1")
        reader.fail(node, "schema: expected \"trunk.sweep/1\"");
    } else if (key == "title") {
      design.title = node.value_or(design.title);
    } else if (key == "scenarios") {
      reader.scenarios(node, design);
    } else if (key == "grid") {
      reader.grid(node, design);
    } else if (key == "output" && node.is_table() && node.as_table()->size() == 1) {
      design.frame_every_ms =
          reader.number(node.as_table()->get("frame_every_ms"), node, "output.frame_every_ms");
      if (design.frame_every_ms <= 0) reader.fail(node, "output.frame_every_ms: expected more than 0");
    } else {
      reader.fail(node, fmt::format("unknown key '{}', expected schema, title, scenarios, [grid] or [output] "
                                    "frame_every_ms",
                                    std::string(key.str())));
    }
  }
  if (design.scenarios.empty())
    throw InputError(design.path, 0, "names no scenarios, expected scenarios = [\"healthy.toml\"]");
  if (design.runs() > most_runs)
    throw InputError(design.path, 0,
                     fmt::format("makes {} runs, expected at most {}", design.runs(), most_runs));
  try_everything(design);
  return design;
}

}  // namespace trunk
