#include "scenarios/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/edit_distance.hpp"

namespace trunk {
namespace {

using Key = ScenarioKey;

/// Returns a path without its unit: geometry.half_width for geometry.half_width_mm.
std::string_view stem(std::string_view path) {
  static constexpr std::string_view units[] = {
      "_N_s_per_m",   "_N_per_m", "_N_s_m", "_N_m", "_kN_per_m", "_mm",  "_cm", "_m", "_ml",
      "_l",           "_L",       "_cl",    "_ms",  "_s",        "_min", "_kg", "_g", "_cmH2O_s_per_L",
      "_cmH2O_per_L", "_cmH2O",   "_mbar",  "_hPa", "_kPa",      "_Pa"};
  for (std::string_view unit : units)
    if (path.ends_with(unit)) return path.substr(0, path.size() - unit.size());
  return path;
}

/// Returns a course that does not change as a number.
std::string toml_course(const Key::Course& key, const PiecewiseLinear& course) {
  if (course.empty()) return "0";
  const auto& first = course.events().front();
  if (course.events().size() == 1 && first.time_s <= 0.0) return fmt::format("{}", first.value / key.to_si);
  return toml_events(course, key.to_si);
}

}  // namespace

std::string expectation(const ScenarioKey& key) {
  if (const auto* n = std::get_if<Key::Number>(&key.kind))
    return fmt::format("a number{}{}, {:g} to {:g}{}", n->unit.empty() ? "" : " of ", n->unit, n->low,
                       n->high, n->automatic ? ", or \"auto\"" : "");
  if (const auto* c = std::get_if<Key::Course>(&key.kind))
    return fmt::format("a number of {}, {:g} to {:g}, or a list of [time in s, number] pairs", c->unit,
                       c->low, c->high);
  if (const auto* c = std::get_if<Key::Choice>(&key.kind))
    return fmt::format("one of \"{}\"", fmt::join(c->names, "\", \""));
  if (const auto* i = std::get_if<Key::Integer>(&key.kind))
    return fmt::format("a whole number, {} to {}", i->low, i->high);
  if (std::holds_alternative<Key::File>(key.kind)) return "the name of a file, in quotes";
  return std::holds_alternative<Key::Switch>(key.kind) ? "true or false" : "a text in quotes";
}

std::string unit_of_key(std::string_view path) {
  for (const Key& key : scenario_keys())
    if (const auto* n = std::get_if<Key::Number>(&key.kind); n && key.path == path) {
      if (n->unit == "N_per_m") return "N m-1";
      if (n->unit == "N_s_per_m") return "N s m-1";
      if (n->unit == "cmH2O_per_L") return "cmH2O L-1";
      if (n->unit == "cmH2O_s_per_L") return "cmH2O s L-1";
      return n->unit.empty() ? "1" : std::string(n->unit);
    } else if (const auto* c = std::get_if<Key::Course>(&key.kind); c && key.path == path) {
      return std::string(c->unit);
    }
  return "1";
}

std::string nearest_key(std::string_view unknown) {
  const std::size_t tolerated = 3;
  std::string_view nearest;
  std::size_t fewest = tolerated + 1;
  for (const Key& key : scenario_keys()) {
    if (stem(key.path) == stem(unknown)) return std::string(key.path);
    const std::size_t edits = edit_distance(unknown, key.path);
    if (edits < fewest) {
      fewest = edits;
      nearest = key.path;
    }
  }
  return std::string(nearest);
}

std::string toml_events(const PiecewiseLinear& course, double to_si) {
  std::string text;
  for (const auto& event : course.events())
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", event.time_s, event.value / to_si);
  return "[" + text + "]";
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (char ch : text) {
    const auto code = static_cast<unsigned char>(ch);
    if (code < 0x20 || code == 0x7F) {
      quoted += fmt::format("\\u{:04X}", code);
      continue;
    }
    if (ch == '"' || ch == '\\') quoted += '\\';
    quoted += ch;
  }
  return quoted + "\"";
}

std::string toml_value(const ScenarioKey& key, const Scenario& scenario) {
  Scenario& s = const_cast<Scenario&>(scenario);  // the accessors serve reading and writing
  if (const auto* n = std::get_if<Key::Number>(&key.kind))
    return n->automatic && n->automatic(s) ? "\"auto\"" : fmt::format("{}", n->field(s) / n->to_si);
  if (const auto* c = std::get_if<Key::Course>(&key.kind)) return toml_course(*c, c->field(s));
  if (const auto* i = std::get_if<Key::Integer>(&key.kind)) return fmt::format("{}", i->field(s));
  if (const auto* c = std::get_if<Key::Choice>(&key.kind))
    return fmt::format("\"{}\"", c->names[static_cast<std::size_t>(c->get(scenario))]);
  if (const auto* b = std::get_if<Key::Switch>(&key.kind)) return b->field(s) ? "true" : "false";
  if (const auto* f = std::get_if<Key::File>(&key.kind)) return toml_text(f->field(s));
  return toml_text(std::get<Key::Text>(key.kind).field(s));
}

}  // namespace trunk
