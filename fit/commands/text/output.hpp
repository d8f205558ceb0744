#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/records.hpp"
#include "subject/json.hpp"

namespace trunk {

/// The exit codes of the program.
enum class Exit {
  done = 0,
  different = 1,
  bad_input = 2,
  not_converged = 3,
  not_identifiable = 4,
  interrupted = 130
};

/// The options that every command has.
struct Common {
  std::string argv;  // the command line as the user typed it
  bool json = false;
  bool force = false;
};

/// Print to stdout. They throw InputError if it cannot be written; output that is not flushed may still fail.
void print_text(const std::string& text);
void flush_text();

/// Prints the JSON object to stdout if the user asked for JSON, else the text.
void print_result(const Common& common, const Json& json, const std::string& text);

/// Notes, errors and progress go to stderr, an error after "trunk: ". A progress line is drawn only on a
/// terminal, over the one before.
void print_note(const std::string& text);
void print_error(const std::string& text);
void print_progress(const std::string& text);
void clear_progress();

/// Returns the number as a table shows it, by a format of fmt, or "not known" if it is not finite.
std::string shown(double value, const char* format);

/// Returns one line "name   value unit" for each value, in columns.
std::string aligned(const std::vector<NamedValue>& values);

/// After the first call, Ctrl-C and SIGTERM no longer end the program; interrupted() returns true instead.
void catch_interrupts();
bool interrupted();

}  // namespace trunk
