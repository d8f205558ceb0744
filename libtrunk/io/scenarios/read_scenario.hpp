#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "anatomy/scenario.hpp"

namespace trunk {

/// A scenario, and where its values come from.
struct ScenarioFile {
  Scenario scenario;
  std::string path;
  std::string text;                           // the file as read
  std::vector<std::filesystem::path> inputs;  // the file and all files that it names, for the provenance
  std::string mesh_read;                      // the file that scenario.mesh comes from
  std::map<std::string, Place> origin;        // path of a key -> place of the value that counts

  std::set<std::string> settings;  // the keys that settings replaced, as --set does

  /// Returns the place where the key is set, or the file if it is set nowhere.
  Place where(const std::string& key) const;
};

/// A value that replaces one of a scenario, as --set and sweeps do.
struct Setting {
  std::string key, value;
  Place at;  // for messages: the option "--set key=value", or the line of a sweep
};

/// Returns the parts of "key=value"; throws InputError if there is no "=".
Setting setting_of(const std::string& text);

/// Reads a scenario. The file of `extends = "other.toml"` (relative to the scenario) is read first, and the
/// scenario replaces its values. `settings` are texts "key=value" as given to --set, and are applied last.
///
/// Throws InputErrors with all mistakes, each with its file and line: wrong TOML syntax, unknown keys, wrong
/// units, numbers that are out of range or not finite, and a chain of files that extends itself.
ScenarioFile read_scenario(const std::filesystem::path& path, const std::vector<std::string>& settings = {});

/// Reads a scenario from its text and the PML text of its trunk, as results files store them. `trunk_pml` is
/// "" for the parametric trunk. Throws as read_scenario does.
ScenarioFile scenario_of_text(const std::string& text, const std::string& name, const std::string& trunk_pml);

/// Replaces values of a scenario. Throws as read_scenario does.
void apply_settings(const std::vector<Setting>& settings, ScenarioFile& file);
void apply_settings(const std::vector<std::string>& settings, ScenarioFile& file);

/// Returns the whole scenario as TOML with the value of every key. Reading it gives the same scenario.
std::string to_toml(const Scenario& scenario);

}  // namespace trunk
