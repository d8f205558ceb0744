#include "surfaces/formats/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "errors/input_error.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr const char* any_white = " \t\v\f\r\n";
constexpr const char* within_line = " \t\v\f";

}  // namespace

bool same_word(std::string_view a, std::string_view b) noexcept {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

void Words::skip_blanks(const char* blanks) {
  const std::size_t next = std::min(text_.find_first_not_of(blanks, position_), text_.size());
  for (; position_ < next; ++position_) {
    const char c = text_[position_];
    const bool crlf = c == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
    if (c == '\n' || (c == '\r' && !crlf)) line_ += line_ > 0;
  }
}

bool Words::at_end() {
  skip_blanks(any_white);
  return position_ >= text_.size();
}

std::string_view Words::next() {
  skip_blanks(any_white);
  return word_of_line();
}

std::string_view Words::word_of_line() {
  skip_blanks(within_line);
  const std::size_t end = std::min(text_.find_first_of(any_white, position_), text_.size());
  const std::string_view word = text_.substr(position_, end - position_);
  position_ = end;
  return word;
}

std::string_view Words::rest_of_line() {
  skip_blanks(within_line);
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  std::string_view rest = text_.substr(position_, end - position_);
  rest = rest.substr(0, rest.find_last_not_of(within_line) + 1);
  position_ = end;
  if (position_ < text_.size()) {
    position_ += text_.substr(position_, 2) == "\r\n" ? 2 : 1;
    line_ += line_ > 0;
  }
  return rest;
}

std::string_view Words::bytes(std::size_t count) {
  line_ = 0;
  if (text_.size() - position_ < count)
    fail("the file ends within its binary numbers", "", "check that the export was finished");
  const std::string_view taken = text_.substr(position_, count);
  position_ += count;
  return taken;
}

double Words::number(const char* what) {
  return number(next(), what);
}

double Words::number_of_line(const char* what) {
  return number(word_of_line(), what);
}

double Words::number(std::string_view word, const char* what) const {
  if (word.empty())
    fail(fmt::format("the {} ends here", position_ < text_.size() ? "line" : "file"), what,
         "check that the export was finished");
  char plain[64];
  const std::size_t length = std::min(word.size(), sizeof plain);
  for (std::size_t i = 0; i < length; ++i)
    plain[i] = word[i] == 'D' || word[i] == 'd' ? 'e' : word[i] == ',' ? '.' : word[i];
  const char* const begin = plain + (length > 1 && plain[0] == '+' && plain[1] != '-' ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, plain + length, value);
  if (word.size() > sizeof plain || error == std::errc::invalid_argument || end != plain + length)
    fail(fmt::format("{} found", excerpt(word)), what, "correct it");
  if (error == std::errc::result_out_of_range) {  // a denormal is 0 here, an overflow an error
    if (word.find('-', 1) != std::string_view::npos) return 0.0;
    value = HUGE_VAL;
  }
  if (!std::isfinite(value))
    fail(fmt::format("{} found", excerpt(word)), fmt::format("{}, a finite number", what),
         "remove or correct the point");
  return value;
}

std::size_t Words::count(const char* what, std::size_t most) {
  const std::string_view word = next();
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || value > most)
    fail(fmt::format("{} found", excerpt(word)), fmt::format("{}, a whole number of 0 to {}", what, most),
         "correct it, or thin the surface");
  return value;
}

void Words::fail(std::string found, std::string expected, std::string remedy) const {
  throw InputError({file_, line_}, std::move(found), std::move(expected), std::move(remedy));
}

}  // namespace trunk
