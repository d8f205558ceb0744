#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/read_scenario.hpp"

namespace trunk {

/// A sweep as its TOML file describes it: every scenario with every subject, every combination of the grid's
/// values and every point of the sample. Run numbers count from 0, in that order, the sample fastest.
struct SweepDesign {
  /// A file as the design names it.
  struct Source {
    std::string name;
    std::filesystem::path path;
    std::string where;  // file:line, for messages
  };
  struct Axis {
    std::string key;             // of a scenario, as in --set
    std::string where;           // file:line
    std::vector<double> values;  // of the grid, to combine; of the sample, one a point
  };
  /// What is kept of a run: its row; also its curve; also a file of its own with the trajectory.
  enum class Store { summary, curves, full };

  std::string title = "sweep";
  std::string path, text;
  std::vector<Source> scenarios, subjects;  // no subjects: the scenarios as they are
  std::vector<Axis> grid, sample;
  std::size_t points = 1;  // of the sample
  Store store = Store::full;
  double frame_every_ms =
      100.0;  // between stored frames: 10 times the scenarios' default, to keep files small

  std::size_t runs() const noexcept;

  /// What a run consists of.
  struct Run {
    std::size_t scenario, subject;
    std::vector<double> values;  // the grid's, then the sample's
  };
  Run run(std::size_t number) const;
  std::string scenario_name(std::size_t run) const;  // without its ending
  std::string subject_name(std::size_t run) const;   // "" where there are no subjects
  std::vector<Setting> settings_of(const std::vector<double>& values) const;

  /// Runs of the same number differ in nothing but subject, parameters and activation.
  std::size_t model_of(std::size_t run) const;

  std::vector<const Axis*> axes() const;  // the grid's, then the sample's

  /// A message that names files as the design does, so that a row does not tell from where it was called.
  std::string seen_from_design(std::string message) const;
};

/// Reads `schema = "trunk.sweep/1"`, `title`, `store = "summary" | "curves" | "full"`, `scenarios = [...]`
/// and `subjects = [...]` (files of runs or fits, whose parameters and activation replace the scenario's; all
/// relative to the file), `[grid]` with "scenario.key" = [values] or { from, to, count, scale = "linear" |
/// "log" }, `[sample]` with `method = "sobol" | "latin_hypercube"`, `points`, `seed` and "scenario.key" =
/// { from, to, scale }, and `[output] frame_every_ms`. Throws InputError with file and line.
SweepDesign parse_sweep_design(const std::string& text, const std::string& path);

/// The same, and what it names is read once, and every key and value tried on every scenario, before anything
/// runs. Throws InputError.
SweepDesign read_sweep_design(const std::filesystem::path& path);

}  // namespace trunk
