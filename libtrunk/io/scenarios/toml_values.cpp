#include "scenarios/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "errors/input_error.hpp"

namespace trunk {

std::filesystem::path beside(const Place& place, const std::string& name) {
  const bool in_file = place.line > 0;
  const auto folder = in_file ? std::filesystem::path(place.file).parent_path() : std::filesystem::path();
  return std::filesystem::absolute(folder / name).lexically_normal();
}

std::string shown(const toml::node& node) {
  std::ostringstream out;
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  node.visit([&](const auto& value) { out << value; });
  std::string text = out.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

toml::table parse_toml(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError({file, error.source().begin.line},
                     fmt::format("not valid TOML: {}", error.description()));
  }
}

double number_of(const toml::node& node, const std::string& what, const std::string& expected,
                 const Place& place) {
  const auto value = node.value<double>();
  if (!value || node.is_boolean() || node.is_string())
    throw InputError(place, fmt::format("{} is {}", what, shown(node)), expected);
  if (!std::isfinite(*value)) throw InputError(place, fmt::format("{} is not finite", what), expected);
  return *value;
}

PiecewiseLinear events_of(const toml::node& node, const std::string& what, double to_si, double before,
                          const Place& place) {
  const std::string expected = "a list of [time in s, value] pairs, times increasing";
  const toml::array* list = node.as_array();
  if (!list || list->empty()) throw InputError(place, fmt::format("{} is {}", what, shown(node)), expected);
  std::vector<PiecewiseLinear::Event> events;
  for (const toml::node& item : *list) {
    const toml::array* pair = item.as_array();
    if (!pair || pair->size() != 2)
      throw InputError(place, fmt::format("{} has {}", what, shown(item)), expected);
    events.push_back({number_of(*pair->get(0), what, expected, place),
                      to_si * number_of(*pair->get(1), what, expected, place)});
  }
  try {
    return PiecewiseLinear(std::move(events), before);
  } catch (const InputError& error) {
    Mistake mistake = error.mistake();
    mistake.at = place;
    mistake.found = fmt::format("{}: {}", what, mistake.found);
    throw InputError(std::move(mistake));
  }
}

Vec3d direction_of(const toml::node& node, const std::string& what, const Place& place) {
  const std::string expected = "three numbers [right, forward, up]";
  const toml::array* list = node.as_array();
  if (!list || list->size() != 3)
    throw InputError(place, fmt::format("{} is {}", what, shown(node)), expected);
  const auto at = [&](std::size_t i) { return number_of(*list->get(i), what, expected, place); };
  return {at(0), at(1), at(2)};
}

}  // namespace trunk
