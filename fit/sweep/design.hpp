#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "errors/input_error.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// A sweep as its TOML file describes it. It combines every scenario with every subject, every combination of
/// the grid's values and every point of the sample. Run numbers count from 0 in that order; the sample varies
/// fastest.
struct SweepDesign {
  /// A file as the design names it.
  struct Source {
    std::string name;
    std::filesystem::path path;
    Place at;  // where the design names it
  };
  /// A key of the scenario that varies.
  struct Axis {
    std::string key;             // of a scenario, as in --set
    Place at;                    // where the design names it
    std::vector<double> values;  // grid: the values to combine; sample: one value for each point
  };
  /// What is stored of a run: only its row, also its curve, or also a file with its trajectory.
  enum class Store { summary, curves, full };

  std::string title = "sweep";
  std::string path, text;
  std::vector<Source> scenarios, subjects;  // without subjects the scenarios are used as they are
  std::vector<Axis> grid, sample;
  std::size_t points = 1;  // of the sample
  Store store = Store::full;
  double frame_every_ms = 100.0;  // 10 times the default of scenarios, to keep files small
  bool intervals = true;          // rows have intervals, where the subject is a fit that keeps draws
  std::size_t draws = 0;          // the most that one subject has; only read_sweep_design counts them

  std::size_t runs() const noexcept;

  /// The scenario, subject and values of a run.
  struct Run {
    std::size_t scenario, subject;
    std::vector<double> values;  // the grid's, then the sample's
  };
  Run run(std::size_t number) const;
  std::string scenario_name(std::size_t run) const;  // without its ending
  std::string subject_name(std::size_t run) const;   // "" if there are no subjects
  std::vector<Setting> settings_of(const std::vector<double>& values) const;

  /// Returns a number that is the same for runs that differ only in subject, parameters and activation.
  std::size_t model_of(std::size_t run) const;

  std::vector<const Axis*> axes() const;  // the grid's, then the sample's

  /// Returns the place with a file in the design's folder named relative to that folder, so that a row does
  /// not depend on the folder that the program was called from.
  Place seen_from_design(Place place) const;
};

/// Returns the design in a text. The keys are `schema = "trunk.sweep/1"`, `title`, `store = "summary" |
/// "curves" | "full"`, `scenarios = [...]`, `subjects = [...]` (files of runs or fits, whose parameters and
/// activation replace the scenario's), `[grid]` with "scenario.key" = [values] or { from, to, count, scale =
/// "linear" | "log" },
/// `[sample]` with `method = "sobol" | "latin_hypercube"`, `points`, `seed` and "scenario.key" = { from, to,
/// scale }, and `[output] frame_every_ms, intervals = true | false`. File names are relative to `path`.
/// Throws InputError with file and line.
SweepDesign parse_sweep_design(const std::string& text, const std::string& path);

/// Returns the design in a file. It also reads every file that the design names, and tries every key and
/// value on every scenario, so that a mistake shows before anything runs. Throws InputError.
SweepDesign read_sweep_design(const std::filesystem::path& path);

}  // namespace trunk
