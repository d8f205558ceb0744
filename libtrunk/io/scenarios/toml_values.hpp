#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

#include "errors/input_error.hpp"
#include "math/piecewise_linear.hpp"
#include "math/vec3.hpp"

namespace trunk {

/// Returns the absolute path of a file that is named at `place`: relative to the folder of the file, or to
/// the working folder if `place` is an option (line 0).
std::filesystem::path beside(const Place& place, const std::string& name);

/// Returns a value as messages quote it: on one line, cut after 60 characters.
std::string shown(const toml::node& node);

/// Returns the table of a TOML text; throws InputError with file and line if the text is not valid TOML.
toml::table parse_toml(const std::string& text, const std::string& file);

/// Readers of one value, which messages call `what`. They throw InputError at `place` if the value has
/// another type, if a number is not finite or if times do not increase.
double number_of(const toml::node& node, const std::string& what, const std::string& expected,
                 const Place& place);
PiecewiseLinear events_of(const toml::node& node, const std::string& what, double to_si, double before,
                          const Place& place);
Vec3d direction_of(const toml::node& node, const std::string& what, const Place& place);

}  // namespace trunk
