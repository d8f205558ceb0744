#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "records/stored_subject.hpp"
#include "scenarios/toml_values.hpp"
#include "sweep/design.hpp"
#include "sweep/sampling.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_runs = 1'000'000, largest_file = 1'000'000, most_files = 10'000;
constexpr std::size_t most_numbers = 10'000'000;  // of all points of a sample
constexpr std::size_t most_coordinates = 40;      // GSL's Sobol sequences

/// A range of values; at(part) is its value at a part between 0 and 1.
struct Range {
  double from, to;
  bool log;
  double at(double part) const { return log ? from * std::pow(to / from, part) : from + part * (to - from); }
};

class DesignReader {
 public:
  explicit DesignReader(SweepDesign& design) : design_(design) {}

  void read(const toml::table& root) {
    for (const auto& [key, node] : root) read_key(std::string(key.str()), node);
    if (design_.scenarios.empty())
      throw InputError({design_.path}, "names no scenarios", "scenarios = [\"healthy.toml\"]");
    for (const auto& a : design_.grid)
      for (const auto& b : design_.sample)
        if (a.key == b.key) throw InputError(b.at, b.key + " is in [grid] too", "it in one of the two");
    if (design_.runs() > most_runs)
      throw InputError({design_.path}, fmt::format("makes {} runs", design_.runs()),
                       fmt::format("at most {}", most_runs));
  }

 private:
  Place place(const toml::node& node) const { return {design_.path, node.source().begin.line}; }
  [[noreturn]] void fail(const toml::node& node, const std::string& found,
                         const std::string& expected) const {
    throw InputError(place(node), found, expected);
  }

  void read_key(const std::string& key, const toml::node& node) {
    if (key == "schema")
      choice(node, key, {"trunk.sweep/1"});
    else if (key == "title")
      design_.title = text(node, key);
    else if (key == "store")
      design_.store = static_cast<SweepDesign::Store>(choice(node, key, {"summary", "curves", "full"}));
    else if (key == "scenarios" || key == "subjects")
      (key == "scenarios" ? design_.scenarios : design_.subjects) = files(node, key);
    else if (key == "grid")
      read_grid(table(node, key));
    else if (key == "sample")
      read_sample(table(node, key));
    else if (key == "output")
      read_output(table(node, key));
    else
      fail(node, fmt::format("unknown key '{}'", key),
           "schema, title, store, scenarios, subjects, [grid], [sample] or [output]");
  }

  double number(const toml::node* node, const toml::node& parent, const std::string& what) const {
    const auto value = node && node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value))
      fail(node ? *node : parent, node ? what + " is " + shown(*node) : "there is no " + what,
           "a finite number");
    return *value;
  }

  std::size_t count(const toml::node* node, const toml::node& parent, const std::string& what, double least,
                    double most) const {
    const double value = number(node, parent, what);
    if (value != std::floor(value) || value < least || value > most)
      fail(*node, what + " is " + shown(*node), fmt::format("a whole number, {} to {}", least, most));
    return static_cast<std::size_t>(value);
  }

  std::string text(const toml::node& node, const std::string& what) const {
    const auto value = node.value_exact<std::string>();
    if (!value) fail(node, what + " is " + shown(node), "a text in quotes");
    return *value;
  }

  std::size_t choice(const toml::node& node, const std::string& what,
                     const std::vector<std::string>& words) const {
    const std::string found = text(node, what);
    const auto at = std::find(words.begin(), words.end(), found);
    if (at == words.end())
      fail(node, fmt::format("{} is '{}'", what, found), fmt::format("\"{}\"", fmt::join(words, "\" or \"")));
    return static_cast<std::size_t>(at - words.begin());
  }

  const toml::table& table(const toml::node& node, const std::string& name) const {
    if (!node.is_table())
      fail(node, name + " is " + shown(node),
           fmt::format("a table, as in [{}] and \"parameters.k_muscle_N_per_m\" = {}", name,
                       name == "grid" ? "[20, 30]" : "{ from = 20, to = 30 }"));
    return *node.as_table();
  }

  std::vector<SweepDesign::Source> files(const toml::node& node, const std::string& what) const {
    const toml::array* list = node.as_array();
    if (!list || list->empty() || list->size() > most_files)
      fail(node, what + " is " + shown(node), fmt::format("a list of 1 to {} files", most_files));
    std::vector<SweepDesign::Source> sources;
    for (const toml::node& item : *list) {
      const std::string name = text(item, what);
      sources.push_back({name, std::filesystem::path(design_.path).parent_path() / name, place(item)});
    }
    return sources;
  }

  void require_full_name(const std::string& key, const toml::node& node, const std::string& table) const {
    if (key.find('.') == std::string::npos)
      fail(node, fmt::format("unknown key '{}' in [{}]", key, table),
           fmt::format("the full name in quotes, as in \"parameters.{}\"", key));
  }

  /// `others` are the keys that the table may hold besides from, to and scale.
  Range range(const toml::table& t, const std::string& key, const std::vector<std::string>& others) const {
    for (const auto& [name, node] : t)
      if (name != "from" && name != "to" && name != "scale" &&
          std::find(others.begin(), others.end(), name.str()) == others.end())
        fail(node, fmt::format("unknown '{}' in {}", std::string(name.str()), key),
             fmt::format("from, to{}{} and scale", others.empty() ? "" : ", ", fmt::join(others, ", ")));
    Range range{number(t.get("from"), t, key + ".from"), number(t.get("to"), t, key + ".to"), false};
    if (const toml::node* scale = t.get("scale"))
      range.log = choice(*scale, key + ".scale", {"linear", "log"}) == 1;
    if (range.log && (range.from <= 0 || range.to <= 0))
      fail(t, fmt::format("{} goes from {} to {} on a log scale", key, range.from, range.to),
           "values above 0");
    return range;
  }

  void read_grid(const toml::table& grid) {
    for (const auto& [key, node] : grid) {
      const std::string name(key.str());
      require_full_name(name, node, "grid");
      design_.grid.push_back({name, place(node), grid_values(name, node)});
    }
  }

  std::vector<double> grid_values(const std::string& key, const toml::node& node) const {
    std::vector<double> values;
    if (const toml::array* list = node.as_array())
      for (const toml::node& item : *list) values.push_back(number(&item, node, key));
    if (const toml::table* t = node.as_table()) {
      const Range walk = range(*t, key, {"count"});
      const std::size_t n = count(t->get("count"), *t, key + ".count", 1, most_runs);
      for (std::size_t i = 0; i < n; ++i)
        values.push_back(walk.at(n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0));
    }
    if (values.empty())
      fail(node, key + " is " + shown(node),
           "a list of numbers or { from = 1, to = 2, count = 5, scale = \"log\" }");
    return values;
  }

  void read_sample(const toml::table& sample) {
    std::vector<Range> ranges;
    std::size_t method = 2, seed = 1;
    for (const auto& [key, node] : sample) {
      const std::string name(key.str());
      if (name == "method") {
        method = choice(node, "sample.method", {"sobol", "latin_hypercube"});
      } else if (name == "points") {
        design_.points = count(&node, node, "sample.points", 1, most_runs);
      } else if (name == "seed") {
        seed = count(&node, node, "sample.seed", 0, 4294967295.0);
      } else {
        require_full_name(name, node, "sample");
        if (!node.is_table())
          fail(node, name + " is " + shown(node), "a range, { from = 1, to = 2, scale = \"log\" }");
        ranges.push_back(range(*node.as_table(), name, {}));
        design_.sample.push_back({name, place(node), {}});
      }
    }
    if (method > 1)
      fail(sample, "there is no sample.method", "method = \"sobol\" or method = \"latin_hypercube\"");
    if (!sample.get("points"))
      fail(sample, "there is no sample.points", "the number of points, as in points = 100");
    if (ranges.empty())
      fail(sample, "the sample has no range", "a range, \"scenario.key\" = { from = 1, to = 2 }");
    if (ranges.size() > most_coordinates)
      fail(sample, fmt::format("the sample has {} ranges", ranges.size()),
           fmt::format("at most {}", most_coordinates));
    if (ranges.size() * design_.points > most_numbers)
      fail(sample, fmt::format("the sample has {} points of {} values", design_.points, ranges.size()),
           fmt::format("at most {} values in all", most_numbers));
    fill_sample(ranges, method == 0 ? &sobol_points : &latin_hypercube, static_cast<unsigned>(seed));
  }

  void fill_sample(const std::vector<Range>& ranges, decltype(&sobol_points) points_in_cube, unsigned seed) {
    const auto cube = points_in_cube(ranges.size(), design_.points, seed);
    for (std::size_t a = 0; a < ranges.size(); ++a)
      for (const double part : cube[a]) design_.sample[a].values.push_back(ranges[a].at(part));
  }

  void read_output(const toml::table& output) {
    for (const auto& [key, node] : output)
      if (key == "frame_every_ms")
        read_frame_every(node);
      else if (key == "intervals")
        design_.intervals = yes_or_no(node, "output.intervals");
      else
        fail(node, fmt::format("unknown key '{}' in [output]", std::string(key.str())),
             "frame_every_ms or intervals");
  }

  void read_frame_every(const toml::node& node) {
    design_.frame_every_ms = number(&node, node, "output.frame_every_ms");
    if (design_.frame_every_ms <= 0)
      fail(node, fmt::format("output.frame_every_ms is {}", design_.frame_every_ms), "a number above 0");
  }

  bool yes_or_no(const toml::node& node, const std::string& what) const {
    const auto value = node.value_exact<bool>();
    if (!value) fail(node, what + " is " + shown(node), "true or false");
    return *value;
  }

  SweepDesign& design_;
};

/// Returns the first, lowest and highest value of a sample, to try instead of all values.
std::vector<double> some_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {values.front(), *low, *high};
}

/// Tries every file, key and value, so that a mistake shows before the first run and not after an hour.
/// => design.draws
void try_everything(SweepDesign& design) {
  std::error_code ignored;
  for (const auto& source : design.scenarios) {
    if (!std::filesystem::exists(source.path, ignored))
      throw InputError(source.at, "there is no scenario file " + source.path.string());
    const ScenarioFile file = read_scenario(source.path);
    if (file.scenario.automatic_step)
      throw InputError(source.at, "time.dt_ms of " + source.name + " is \"auto\"",
                       "a number, so that all runs have the same time step",
                       "set the step that `trunk simulate` chooses for this scenario, or steps in [grid]");
    const auto try_values = [&](const SweepDesign::Axis& axis, const std::vector<double>& values) {
      for (const double value : values) {
        ScenarioFile trial = file;
        apply_settings(std::vector<Setting>{{axis.key, fmt::format("{}", value), axis.at}}, trial);
      }
    };
    for (const SweepDesign::Axis& axis : design.grid) try_values(axis, axis.values);
    for (const SweepDesign::Axis& axis : design.sample) try_values(axis, some_of(axis.values));
  }
  for (const auto& subject : design.subjects) try {
      Scenario trial;
      const StoredSubject stored = read_stored_subject(subject.path);
      if (!stored.gates.empty())
        throw InputError({subject.path.string()},
                         fmt::format("a gate stopped this fit: {}", stored.gates.front().sentence),
                         "fits of breaths that a muscle drives", "leave this subject out");
      breathe_as(stored, trial);
      design.draws = std::max(design.draws, stored.draws.size());
    } catch (const InputError& error) {
      rethrow_named_in(subject.at, error);
    }
}

}  // namespace

SweepDesign parse_sweep_design(const std::string& text, const std::string& path) {
  SweepDesign design;
  design.path = path;
  design.text = text;
  DesignReader(design).read(parse_toml(text, path));
  return design;
}

SweepDesign read_sweep_design(const std::filesystem::path& path) {
  SweepDesign design = parse_sweep_design(read_text_file(path, largest_file), path.string());
  try_everything(design);
  return design;
}

}  // namespace trunk
