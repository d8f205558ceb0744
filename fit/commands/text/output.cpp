#include "commands/text/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>

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

}  // namespace

Json json_number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

void print_result(const Common& common, const Json& json, const std::string& text) {
  clear_progress();
  fmt::print("{}\n", common.json ? json.dump(2) : text);
}

void print_note(const std::string& text) {
  clear_progress();
  fmt::print(stderr, "{}\n", text);
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

void require_apart(const std::vector<std::filesystem::path>& inputs,
                   const std::vector<std::filesystem::path>& outputs) {
  const auto same = [](const auto& a, const auto& b) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(a)) ==
           std::filesystem::weakly_canonical(std::filesystem::absolute(b));
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const auto& input : inputs)
      if (same(input, outputs[i]))
        throw InputError(outputs[i].string(), 0,
                         "is read by this command, expected another name for the result");
    for (std::size_t j = 0; j < i; ++j)
      if (same(outputs[j], outputs[i]))
        throw InputError(outputs[i].string(), 0, "is named for two results, expected two names");
  }
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
