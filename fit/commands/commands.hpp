#pragma once

#include <CLI/CLI.hpp>

#include "commands/text/output.hpp"

namespace trunk {

/// Each adds one subcommand to the program. When it is chosen, `run` is set to what does its work.
using Run = std::function<Exit()>;
void add_simulate(CLI::App& app, Common& common, Run& run);
void add_check(CLI::App& app, Common& common, Run& run);
void add_breaths(CLI::App& app, Common& common, Run& run);
void add_fit(CLI::App& app, Common& common, Run& run);
void add_sweep(CLI::App& app, Common& common, Run& run);
void add_status(CLI::App& app, Common& common, Run& run);
void add_merge(CLI::App& app, Common& common, Run& run);
void add_validate(CLI::App& app, Common& common, Run& run);
void add_inspect(CLI::App& app, Common& common, Run& run);
void add_diff(CLI::App& app, Common& common, Run& run);
void add_replay(CLI::App& app, Common& common, Run& run);
void add_export(CLI::App& app, Common& common, Run& run);
void add_register(CLI::App& app, Common& common, Run& run);
void add_compare(CLI::App& app, Common& common, Run& run);
void add_report(CLI::App& app, Common& common, Run& run);

/// A finite number from lowest to highest, for an option; CLI11's own Range lets NaN pass.
std::string require_within(const std::string& text, double lowest, double highest);
inline auto within(double lowest, double highest) {
  return [=](const std::string& text) { return require_within(text, lowest, highest); };
}

}  // namespace trunk
