#include "tables/unit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "tables/column_vocabulary.hpp"

namespace trunk {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || std::isalpha(static_cast<unsigned char>(c));
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// Returns a text without brackets around it, with signs of ASCII for those of typesetters.
std::string normal(std::string_view text) {
  constexpr std::string_view around = " \t[](){}";
  const auto first = text.find_first_not_of(around);
  if (first == std::string_view::npos) return "";
  std::string plain(text.substr(first, text.find_last_not_of(around) - first + 1));
  constexpr std::array<std::array<std::string_view, 2>, 14> signs{{{"⁻", "^-"},
                                                                   {"−", "-"},
                                                                   {"×", "*"},
                                                                   {"·", " "},
                                                                   {"⋅", " "},
                                                                   {"∙", " "},
                                                                   {"¹", "1"},
                                                                   {"⁴", "4"},
                                                                   {"⁶", "6"},
                                                                   {"ℓ", "l"},
                                                                   {"⁄", "/"},
                                                                   {"∕", "/"},
                                                                   {"**", "^"},
                                                                   {"m^3", "m3"}}};
  for (const auto& [from, to] : signs) replace_all(plain, from, to);
  // "10⁻³": a superscript 2 or 3 is part of m³ elsewhere.
  if (plain.starts_with("10^-")) replace_all(plain, "²", "2"), replace_all(plain, "³", "3");
  return plain;
}

// Reads a number without a sign, "0.1" or "0,1", at the beginning of a text, and removes it. "1,000" and
// "10e-3" may mean two things each and are no numbers here.
std::optional<double> take_number(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && (is_digit(text[end]) || text[end] == '.' || text[end] == ',')) ++end;
  if (end == 0 || !is_digit(text[end - 1])) return std::nullopt;
  const std::size_t mantissa = end, mark = text.find_first_of(".,");
  if (mark < end && mark + 4 == end && text[0] != '0') return std::nullopt;
  if (end + 2 < text.size() && (text[end] == 'e' || text[end] == 'E') &&
      (is_digit(text[end + 1]) || text[end + 1] == '-')) {
    end += 2;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (text.substr(0, mantissa) == "10") return std::nullopt;
  }
  std::string number(text.substr(0, end));
  std::replace(number.begin(), number.end(), ',', '.');
  double value = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc{} || stop != number.data() + number.size()) return std::nullopt;
  text.remove_prefix(end);
  return value;
}

// Reads a factor at the beginning of a text, "0.1", "1/100" or "10^-3", and removes it and what joins it to
// the unit. Other numbers than powers of ten may be a range or the size of a syringe.
std::optional<double> take_factor(std::string_view& text) {
  auto factor = take_number(text);
  if (!factor) return std::nullopt;
  if (text.starts_with('^')) {
    text.remove_prefix(1);
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const auto power = take_number(text);
    if (!power) return std::nullopt;
    factor = std::pow(*factor, negative ? -*power : *power);
  } else if (text.size() > 1 && text[0] == '/' && is_digit(text[1])) {
    text.remove_prefix(1);
    const auto below = take_number(text);
    if (!below) return std::nullopt;
    factor = *factor / *below;
  }
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (text.starts_with('*')) text.remove_prefix(1);
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (text.empty() || !is_letter(text[0]) || !(*factor > 0) || !std::isfinite(*factor)) return std::nullopt;
  const double power = std::log10(*factor);
  return std::abs(power - std::round(power)) < 1e-9 ? std::optional(std::pow(10, std::round(power)))
                                                    : std::nullopt;
}

// Returns the small letter for a capital of Latin, Greek or Cyrillic that UTF-8 writes in two bytes (Unicode,
// charts U+0080 to U+04FF); any other character unchanged.
unsigned lower_case(unsigned code) {
  const auto within = [code](unsigned first, unsigned last) { return code >= first && code <= last; };
  const bool even_capitals =
      within(0x100, 0x12F) || within(0x132, 0x137) || within(0x14A, 0x177) || within(0x218, 0x21B);
  const bool odd_capitals = within(0x139, 0x148) || within(0x179, 0x17E);
  if (even_capitals) return code | 1U;
  if (odd_capitals) return code % 2 == 1 ? code + 1 : code;
  if ((within(0xC0, 0xDE) && code != 0xD7) || within(0x391, 0x3A9) || within(0x410, 0x42F))
    return code + 0x20;
  if (within(0x388, 0x38A)) return code + 0x25;
  if (code == 0x386) return 0x3AC;
  if (code == 0x38C) return 0x3CC;
  if (within(0x400, 0x40F)) return code + 0x50;
  return code;
}

std::string without_conditions(std::string plain) {
  for (const std::string_view condition : gas_conditions())
    if (plain.ends_with(condition)) plain.resize(plain.size() - condition.size());
  return plain;
}

// Returns the unit of the vocabulary.
std::optional<Unit> known(std::string_view plain) {
  for (const UnitSpelling& spelling : unit_spellings())
    if (plain == spelling.suffix.substr(1))
      return Unit{std::string(spelling.name), spelling.quantity, spelling.to_si};
  return std::nullopt;
}

std::string_view last_word(std::string_view plain) {
  const auto at = plain.rfind('_');
  return at == std::string_view::npos ? plain : plain.substr(at + 1);
}

std::optional<Unit> any_unit(std::string_view text) {
  // "/min" is a rate and no time, and "%ml" is no volume.
  if (text.empty() || !is_letter(text[0])) return std::nullopt;
  if (text.find_first_of("*%<>=~") != std::string_view::npos) return std::nullopt;
  return plain_unit(plain_name(text));
}

}  // namespace

std::string plain_name(std::string_view header) {
  std::string plain;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto byte = static_cast<unsigned char>(header[i]);
    const bool two = byte >= 0xC2 && byte <= 0xDF && i + 1 < header.size();
    if (two) {
      const unsigned code =
          lower_case((byte & 0x1FU) << 6 | (static_cast<unsigned char>(header[++i]) & 0x3FU));
      plain += static_cast<char>(0xC0 | code >> 6);
      plain += static_cast<char>(0x80 | (code & 0x3F));
    } else if (byte >= 0x80)
      plain += header[i];
    else if (std::isalnum(byte))
      plain += static_cast<char>(std::tolower(byte));
    else if (!plain.empty() && plain.back() != '_')
      plain += '_';
  }
  if (plain.ends_with('_')) plain.pop_back();
  return plain;
}

std::optional<Unit> plain_unit(std::string_view with_conditions) {
  const std::string plain = without_conditions(std::string(with_conditions));
  if (auto unit = known(plain)) return unit;
  std::string_view rest = plain;
  if (rest.ends_with("_1")) rest.remove_suffix(2);  // "l s-1"
  const std::string_view below = last_word(rest);
  if (below.size() == rest.size()) return std::nullopt;
  const auto time = known(below);
  if (!time || time->quantity != Quantity::time) return std::nullopt;
  rest.remove_suffix(below.size() + 1);
  for (const std::string_view per : {"_per", "_pro", "_par", "_por"})
    if (rest.ends_with(per)) rest.remove_suffix(per.size());
  const auto volume = known(rest);
  if (!volume || volume->quantity != Quantity::volume) return std::nullopt;
  return Unit{volume->name + "_" + time->name, Quantity::flow, volume->to_si / time->to_si};
}

std::optional<Unit> unit_of(std::string_view text) {
  const std::string all = normal(text);
  std::string_view rest = all;
  if (auto unit = any_unit(rest)) return unit;
  const auto factor = take_factor(rest);
  if (!factor) return std::nullopt;
  auto unit = any_unit(rest);
  if (!unit || *factor == 1) return unit;
  unit->name = fmt::format("{:g} {}", *factor, unit->name);
  unit->to_si *= *factor;
  return unit;
}

std::string spoken_unit(std::string name) {
  std::replace(name.begin(), name.end(), '_', '/');
  return name;
}

bool looks_like_unit(std::string_view text) {
  constexpr std::array<std::string_view, 13> words{"left", "right", "in",  "out",  "mean", "abs", "est",
                                                   "ref",  "new",   "old", "none", "na",   "n_a"};
  constexpr std::size_t long_unit = 4;  // letters: "inH2O" has a digit, "torr" is known
  const std::string all = normal(text), plain = plain_name(all);
  if (all.empty()) return false;
  if (all.find_first_not_of("0123456789.,xX ") ==
      std::string::npos)  // a factor alone: "0.1", "x10", but not "2"
    return all.find_first_of(".,xX") != std::string::npos || all == "10" || all == "100" || all == "1000";
  if (plain_unit(last_word(plain))) return true;  // "tenths of ml"
  const bool digits = std::any_of(plain.begin(), plain.end(), is_digit);
  if (digits && plain_unit(plain.substr(0, plain.find('_')))) return true;  // "ml x10"
  const auto ignored = ignored_words();
  if (std::find(ignored.begin(), ignored.end(), plain) != ignored.end() ||
      std::find(words.begin(), words.end(), plain) != words.end())
    return false;
  if (all.find_first_of("/*^%") != std::string::npos || all.find("°") != std::string::npos) return true;
  if (plain.find('_') != std::string::npos || std::none_of(plain.begin(), plain.end(), is_letter))
    return false;
  return digits ? !is_digit(plain.back()) : plain.size() <= long_unit;  // "ch2" is a number of a channel
}

}  // namespace trunk
