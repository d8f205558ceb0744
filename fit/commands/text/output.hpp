#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/records.hpp"
#include "subject/json.hpp"

namespace trunk {

/// Exit codes of the program.
enum class Exit {
  done = 0,
  different = 1,
  bad_input = 2,
  not_converged = 3,
  not_identifiable = 4,
  interrupted = 130
};

/// Options every command has.
struct Common {
  std::string argv;  // the command line as typed
  bool json = false;
  bool force = false;
};

/// Prints one JSON object, or the text, to stdout.
void print_result(const Common& common, const Json& json, const std::string& text);

/// Notes and progress go to stderr. A progress line is drawn only on a terminal, over itself.
void print_note(const std::string& text);
void print_progress(const std::string& text);
void clear_progress();

/// The number as a table shows it: `format` as fmt takes it, "not known" where it is not finite.
std::string shown(double value, const char* format);

/// "name   value unit" lines, aligned.
std::string aligned(const std::vector<NamedValue>& values);

/// Ctrl-C and SIGTERM set a flag instead of ending the program, from the first call on.
void catch_interrupts();
bool interrupted();

}  // namespace trunk
