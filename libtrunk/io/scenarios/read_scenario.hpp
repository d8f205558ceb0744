#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "anatomy/scenario.hpp"

namespace trunk {

/// A scenario together with where it came from.
struct ScenarioFile {
  Scenario scenario;
  std::string path;
  std::string text;                           // the file as read
  std::vector<std::filesystem::path> inputs;  // the file and those it extends, for provenance
  std::string mesh_read;                      // the file that scenario.mesh came from
  std::map<std::string, std::string> origin;  // key path -> file:line of the value in force

  /// "file:line" where the key was set, else the file.
  std::string where(const std::string& key) const;
};

/// A value put over a scenario, as --set or a sweep does. `where` is for messages: "--set key=value",
/// file:line.
struct Setting {
  std::string key, value, where;
};

/// Takes "key=value" apart. Throws InputError.
Setting setting_of(const std::string& text);

/// Reads a scenario. `extends = "other.toml"` (relative to the file) is read first and overridden. Throws
/// InputError with file, line, what was found and what was expected on anything that is not understood: TOML
/// syntax, unknown keys, wrong units, numbers out of range or not finite, a chain of files that extends
/// itself; InputErrors, so that one reading finds all that is wrong. `settings` are "key=value" texts as
/// given to --set, applied last.
ScenarioFile read_scenario(const std::filesystem::path& path, const std::vector<std::string>& settings = {});

/// A scenario from its text, as results files keep it, with the PML text of its trunk where it has one.
ScenarioFile scenario_of_text(const std::string& text, const std::string& name, const std::string& trunk_pml);

/// Puts values over a scenario that was read. Throws as read_scenario does.
void apply_settings(const std::vector<Setting>& settings, ScenarioFile& file);
void apply_settings(const std::vector<std::string>& settings, ScenarioFile& file);

/// The whole scenario as TOML, every key with its value: reading it gives the same scenario.
std::string to_toml(const Scenario& scenario);

}  // namespace trunk
