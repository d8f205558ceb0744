#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/scenario_file.hpp"

namespace trunk {

/// A sweep as its TOML file describes it: every scenario with every combination of the grid's values. Run
/// numbers count from 0, the last axis fastest.
struct SweepDesign {
  struct Axis {
    std::string key;    // of a scenario, as in --set
    std::string where;  // file:line, for messages
    std::vector<double> values;
  };
  std::string title = "sweep";
  std::string path, text;
  std::vector<std::filesystem::path> scenarios;
  std::vector<Axis> axes;
  double frame_every_ms =
      100.0;  // between stored frames: 10 times the scenarios' default, to keep files small

  std::size_t runs() const noexcept;
  const std::filesystem::path& scenario_of(std::size_t run) const;
  std::vector<double> values_of(std::size_t run) const;  // one an axis
  std::vector<Setting> settings_of(std::size_t run) const;
};

/// Reads `schema = "trunk.sweep/1"`, `title`, `scenarios = [...]` (relative to the file), `[grid]` with
/// "scenario.key" = [values] or { from, to, count, scale = "linear" | "log" }, and `[output] frame_every_ms`.
/// Every scenario is read once, and every key and value tried on it, before anything runs. Throws InputError.
SweepDesign read_sweep_design(const std::filesystem::path& path);

}  // namespace trunk
