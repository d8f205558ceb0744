#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

#include "math/piecewise_linear.hpp"
#include "math/vec3.hpp"

namespace trunk {

/// Where a TOML value stands, for messages. Line 0: not in a file.
struct TomlPlace {
  std::string file;
  std::size_t line;
  [[noreturn]] void fail(const std::string& text) const;  // throws InputError
  std::string name() const;                               // "file:line"
  /// A file name as the place means it: beside the file, or where the program runs when it is not in one.
  std::filesystem::path beside(const std::string& name) const;
};

/// A value as a message quotes it: one line, cut after 60 characters.
std::string shown(const toml::node& node);

/// Throws InputError with file and line where the text is not TOML.
toml::table parse_toml(const std::string& text, const std::string& file);

/// Readers of one value. `what` names it in messages. Throw InputError: another type, a number that is not
/// finite, times that do not increase.
double number_of(const toml::node& node, const std::string& what, const std::string& expected,
                 const TomlPlace& place);
PiecewiseLinear events_of(const toml::node& node, const std::string& what, double to_si, double before,
                          const TomlPlace& place);
Vec3d direction_of(const toml::node& node, const std::string& what, const TomlPlace& place);

}  // namespace trunk
