#pragma once

#include <stdexcept>
#include <string>

namespace trunk {

/// Something the user gave us cannot be used. The text is one line and reads
/// `file:line: what was found, what was expected, what to do`; the program prints it and exits with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// An error at a line of a file; `line` counts from 1, 0 means the file as a whole.
  InputError(const std::string& file, std::size_t line, const std::string& text)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + text) {}
};

}  // namespace trunk
