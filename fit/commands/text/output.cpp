#include "commands/text/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);
bool progress_shown = false;

extern "C" {
static void note_interrupt(int) {
  was_interrupted = true;
}
}

[[noreturn]] void refuse_output() {
  throw InputError(Place{"standard output"}, "it cannot be written", "", "check whether the disk is full");
}

}  // namespace

void print_text(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) refuse_output();
}

void flush_text() {
  if (std::fflush(stdout) != 0) refuse_output();
}

void print_result(const Common& common, const Json& json, const std::string& text) {
  clear_progress();
  print_text((common.json ? json.dump(2) : text) + "\n");
}

void print_note(const std::string& text) {
  clear_progress();
  fmt::print(stderr, "{}\n", text);
}

void print_error(const std::string& text) {
  print_note("trunk: " + text);
}

void print_progress(const std::string& text) {
  if (!isatty(STDERR_FILENO)) return;
  fmt::print(stderr, "\r\033[K{}", text);
  std::fflush(stderr);
  progress_shown = true;
}

void clear_progress() {
  if (!progress_shown) return;
  fmt::print(stderr, "\r\033[K");
  progress_shown = false;
}

std::string shown(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "not known";
}

std::string aligned(const std::vector<NamedValue>& values) {
  std::size_t width = 0;
  for (const NamedValue& v : values) width = std::max(width, v.name.size());
  std::string text;
  for (const NamedValue& v : values)
    text += fmt::format("  {:<{}}  {:>10} {}\n", v.name, width, shown(v.value, "{:.4g}"),
                        v.unit == "1" ? "" : v.unit);
  return text;
}

void catch_interrupts() {
  std::signal(SIGINT, &note_interrupt);
  std::signal(SIGTERM, &note_interrupt);
}

bool interrupted() {
  return was_interrupted;
}

}  // namespace trunk
