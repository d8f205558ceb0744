#include "breaths/selection.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

constexpr std::size_t largest_number = 999'999;

// Removes a number from the beginning of `rest` and returns it; returns 0 if there is none within bounds.
std::size_t take_number(std::string_view& rest) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error != std::errc() || number > largest_number) return 0;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return number;
}

bool take(std::string_view& rest, char mark) {
  if (rest.empty() || rest.front() != mark) return false;
  rest.remove_prefix(1);
  return true;
}

void check_numbers(const std::string& option, const std::vector<std::size_t>& numbers,
                   const std::vector<Breath>& breaths, const std::string& source) {
  for (const std::size_t number : numbers)
    if (!position_of(breaths, number))
      throw InputError({source}, option + " names breath " + std::to_string(number),
                       std::to_string(breaths.front().number) + " to " +
                           std::to_string(breaths.back().number) + ", the whole breaths found",
                       "list them with trunk breaths");
}

}  // namespace

std::vector<std::size_t> breath_numbers(const std::string& option, const std::string& text) {
  std::vector<std::size_t> numbers;
  std::string_view rest = text;
  do {
    const std::size_t first = take_number(rest), last = take(rest, '-') ? take_number(rest) : first;
    if (first == 0 || last < first || (!rest.empty() && rest.front() != ','))
      throw InputError({option + " " + text.substr(0, 40)}, "this is not a list of breath numbers",
                       "numbers from 1, as in 3,7 or 3-5");
    for (std::size_t number = first; number <= last; ++number) numbers.push_back(number);
  } while (take(rest, ',') && numbers.size() <= largest_number);
  return numbers;
}

std::optional<std::size_t> position_of(const std::vector<Breath>& breaths, std::size_t number) {
  for (std::size_t i = 0; i < breaths.size(); ++i)
    if (breaths[i].number == number) return i;
  return std::nullopt;
}

void overrule(std::vector<Breath>& breaths, const BreathSelection& selection, const std::string& source) {
  check_numbers("--exclude", selection.excluded, breaths, source);
  check_numbers("--include", selection.included, breaths, source);
  for (const std::size_t number : selection.excluded) {
    if (std::count(selection.included.begin(), selection.included.end(), number) > 0)
      throw InputError({source},
                       "breath " + std::to_string(number) + " is named by both --exclude and --include",
                       "one of them");
    Breath& breath = breaths[*position_of(breaths, number)];
    if (breath.kept) breath.kept = false, breath.reason = "excluded by --exclude";
  }
  for (const std::size_t number : selection.included) {
    Breath& breath = breaths[*position_of(breaths, number)];
    if (!breath.kept) breath.kept = true, breath.reason = "included by --include, though " + breath.reason;
  }
}

}  // namespace trunk
