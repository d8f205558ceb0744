#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "commands/text/output.hpp"

namespace trunk {

/// Each of these adds one command to the program. If the user chooses the command, `run` becomes what does
/// its work.
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
void add_help(CLI::App& app, Common& common, Run& run);

/// Add the flag that nearly every command has. `text` says what --force replaces.
void add_json_flag(CLI::App& command, Common& common);
void add_force_flag(CLI::App& command, Common& common, const std::string& text);

/// Returns "" if the text of an option is a number from lowest to highest, else what is wrong with it. Unlike
/// CLI11's Range, it refuses NaN.
std::string require_within(const std::string& text, double lowest, double highest);
inline auto within(double lowest, double highest) {
  return [=](const std::string& text) { return require_within(text, lowest, highest); };
}

/// Checks of an option: its text is one of these names, or a whole number from lowest to highest. Completions
/// offer the names.
CLI::Validator one_of(const std::vector<std::string>& names);
CLI::Validator whole_number(std::int64_t lowest, std::int64_t highest);

}  // namespace trunk
