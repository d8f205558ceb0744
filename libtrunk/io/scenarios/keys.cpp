#include "scenarios/keys.hpp"
#include "text/edit_distance.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trunk {
namespace {

using Key = ScenarioKey;
constexpr double mm = 1e-3, ml = 1e-6, ms = 1e-3, one = 1.0;

template <std::size_t Knot>
double& shape_knot(Scenario& s) {
  return s.activation.shape[Knot];
}

std::vector<Key> make_keys() {
  const auto number = [](auto path, auto unit, double to_si, double low, double high, auto field,
                         auto meaning) {
    return Key{path, meaning, Key::Number{unit, to_si, low, high, field}};
  };
  return {
      {"title", "what this scenario is", Key::Text{[](Scenario& s) -> std::string& { return s.title; }}},

      number(
          "geometry.half_width_mm", "mm", mm, 50, 400,
          [](Scenario& s) -> double& { return s.geometry.half_width; },
          "transverse half-axis of the trunk at the zone of apposition"),
      number(
          "geometry.half_depth_mm", "mm", mm, 30, 300,
          [](Scenario& s) -> double& { return s.geometry.half_depth; },
          "antero-posterior half-axis of the trunk"),
      number(
          "geometry.abdomen_height_mm", "mm", mm, 50, 600,
          [](Scenario& s) -> double& { return s.geometry.abdomen_height; },
          "pelvic floor to costal insertion"),
      number(
          "geometry.apposition_length_mm", "mm", mm, 20, 400,
          [](Scenario& s) -> double& { return s.geometry.apposition_length; },
          "costal insertion to top of the zone of apposition"),
      number(
          "geometry.dome_height_right_mm", "mm", mm, 5, 300,
          [](Scenario& s) -> double& { return s.geometry.dome_height_right; },
          "top of the zone of apposition to the right dome"),
      number(
          "geometry.dome_height_left_mm", "mm", mm, 5, 300,
          [](Scenario& s) -> double& { return s.geometry.dome_height_left; },
          "top of the zone of apposition to the left dome"),
      number(
          "geometry.end_expiratory_volume_ml", "ml", ml, 200, 20000,
          [](Scenario& s) -> double& { return s.geometry.end_expiratory_volume; },
          "lung volume at rest; sets the height of the lung"),
      {"geometry.resolution",
       "particles along a length, times those of the 113-particle mesh; needs a shorter time step",
       Key::Integer{1, 16, [](Scenario& s) -> int& { return s.geometry.resolution; }}},
      {"geometry.pml",
       "a trunk to take instead of the parametric one, whose other geometry keys then do nothing; \"\": none",
       Key::File{[](Scenario& s) -> std::string& { return s.mesh_file; }}},

      number(
          "parameters.k_elasticity_N_per_m", "N_per_m", one, 1e-3, 1e7,
          [](Scenario& s) -> double& { return s.parameters.elasticity; },
          "stiffness of every shape-memory actuator"),
      number(
          "parameters.k_muscle_N_per_m", "N_per_m", one, 0, 1e7,
          [](Scenario& s) -> double& { return s.parameters.muscle; },
          "stiffness of every muscle fibre at full activation"),
      number(
          "parameters.damping_N_s_per_m", "N_s_per_m", one, 0, 1e5,
          [](Scenario& s) -> double& { return s.parameters.damping; }, "viscous damping of a particle"),
      number(
          "parameters.abdomen_stiffness_factor", "", one, 0, 1e4,
          [](Scenario& s) -> double& { return s.parameters.abdomen_factor; },
          "abdominal wall over diaphragm muscle"),

      number(
          "tissue.particle_mass_kg", "kg", one, 1e-6, 100,
          [](Scenario& s) -> double& { return s.tissue.particle_mass; }, "mass of every particle"),
      number(
          "tissue.tendon_stiffness_factor", "", one, 0, 1e4,
          [](Scenario& s) -> double& { return s.tissue.tendon_factor; },
          "central tendon over diaphragm muscle"),
      number(
          "tissue.held_stiffness_factor", "", one, 0, 100,
          [](Scenario& s) -> double& { return s.tissue.held_stiffness; },
          "held particles of abdomen and diaphragm over their own elasticity; 2 for faster convergence with "
          "resolution"),
      {"tissue.reaction", "how shape-memory forces are balanced by the neighbours",
       Key::Choice{{"variational", "published"},
                   [](Scenario& s, int i) { s.reaction = static_cast<Reaction>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.reaction); }}},
      {"tissue.fibres", "where the muscle fibres end; they begin at the costal insertion",
       Key::Choice{{"tendon_border", "apposition_top"},
                   [](Scenario& s, int i) { s.tissue.fibre_end = static_cast<FibreEnd>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.tissue.fibre_end); }}},
      {"tissue.ribs", "rib cage: costal insertion held, zone of apposition kept inside",
       Key::Switch{[](Scenario& s) -> bool& { return s.tissue.ribs; }}},
      number(
          "tissue.rib_friction", "", one, 0, 10, [](Scenario& s) -> double& { return s.tissue.rib_friction; },
          "Coulomb's coefficient between rib cage and zone of apposition"),
      number(
          "tissue.membrane_stiffness_N_per_m", "N_per_m", one, 0, 1e6,
          [](Scenario& s) -> double& { return s.tissue.membrane_stiffness; },
          "resistance to stretch along the edges of abdomen and diaphragm; 0: none, as in the paper"),

      {"paralysis.side", "hemidiaphragm whose fibres are off",
       Key::Choice{{"none", "right", "left", "both"},
                   [](Scenario& s, int i) { s.tissue.paralysed = static_cast<Side>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.tissue.paralysed); }}},
      number(
          "paralysis.stiffness_factor", "", one, 0, 100,
          [](Scenario& s) -> double& { return s.tissue.paralysed_stiffness; },
          "elasticity left in the paralysed half, over the healthy one"),

      number(
          "activation.onset_s", "s", one, -1, 60, [](Scenario& s) -> double& { return s.activation.onset_s; },
          "start of the contraction; below 0 it has begun before the simulation"),
      number(
          "activation.rise_s", "s", one, 1e-3, 60, [](Scenario& s) -> double& { return s.activation.rise_s; },
          "linear rise to 1"),
      number(
          "activation.fast_fall_s", "s", one, 1e-3, 60,
          [](Scenario& s) -> double& { return s.activation.fast_fall_s; }, "the paper's important decrease"),
      number(
          "activation.fast_fall_level", "", one, 0, 1,
          [](Scenario& s) -> double& { return s.activation.fast_fall_level; },
          "activation at the end of the fast fall"),
      number(
          "activation.slow_fall_s", "s", one, 1e-3, 60,
          [](Scenario& s) -> double& { return s.activation.slow_fall_s; },
          "the paper's normal decrease, to 0"),
      number("activation.shape_rise_1", "", one, 0, 100, shape_knot<0>,
             "activation at 1/6 of the rise, over the straight line's"),
      number("activation.shape_rise_2", "", one, 0, 100, shape_knot<1>,
             "activation at 2/6 of the rise, over the straight line's"),
      number("activation.shape_rise_3", "", one, 0, 100, shape_knot<2>,
             "activation at 3/6 of the rise, over the straight line's"),
      number("activation.shape_rise_4", "", one, 0, 100, shape_knot<3>,
             "activation at 4/6 of the rise, over the straight line's"),
      number("activation.shape_rise_5", "", one, 0, 100, shape_knot<4>,
             "activation at 5/6 of the rise, over the straight line's"),
      number("activation.shape_fast_fall_1", "", one, 0, 100, shape_knot<5>,
             "activation at 1/2 of the fast fall, over the straight line's"),
      number("activation.shape_slow_fall_1", "", one, 0, 100, shape_knot<6>,
             "activation at 1/4 of the slow fall, over the straight line's"),
      number("activation.shape_slow_fall_2", "", one, 0, 100, shape_knot<7>,
             "activation at 2/4 of the slow fall, over the straight line's"),
      number("activation.shape_slow_fall_3", "", one, 0, 100, shape_knot<8>,
             "activation at 3/4 of the slow fall, over the straight line's"),
      number(
          "activation.period_s", "s", one, 0, 600,
          [](Scenario& s) -> double& { return s.activation.period_s; },
          "the pattern repeats after this; 0: once"),

      number(
          "time.duration_s", "s", one, 1e-3, 3600, [](Scenario& s) -> double& { return s.time.duration_s; },
          "how long to simulate"),
      {"time.dt_ms", "time step; auto: the longest that shows the lung volume within 0.1 % of short ones",
       Key::Number{"ms", ms, 1e-4, 1000, [](Scenario& s) -> double& { return s.time.dt_s; },
                   [](Scenario& s) -> bool& { return s.automatic_step; }}},
      {"time.damping",
       "velocity that damping acts on in a step: the one at its end, or the mean of both ends",
       Key::Choice{{"implicit", "centred"},
                   [](Scenario& s, int i) { s.time.damping = static_cast<Damping>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.time.damping); }}},
      number(
          "time.frame_every_ms", "ms", ms, 0, 1e6, [](Scenario& s) -> double& { return s.frame_every_s; },
          "between stored frames; 0: none, and curves every 10 ms"),
  };
}

/// The name without its unit: geometry.half_width_mm -> geometry.half_width.
std::string_view stem(std::string_view path) {
  static constexpr std::string_view units[] = {"_N_s_per_m", "_N_per_m", "_N_s_m", "_N_m", "_kN_per_m", "_mm",
                                               "_cm",        "_m",       "_ml",    "_l",   "_L",        "_cl",
                                               "_ms",        "_s",       "_min",   "_kg",  "_g"};
  for (std::string_view unit : units)
    if (path.ends_with(unit)) return path.substr(0, path.size() - unit.size());
  return path;
}

}  // namespace

std::span<const ScenarioKey> scenario_keys() {
  static const std::vector<Key> keys = make_keys();
  return keys;
}

std::string expectation(const ScenarioKey& key) {
  if (const auto* n = std::get_if<Key::Number>(&key.kind))
    return fmt::format("a number{}{}, {:g} to {:g}{}", n->unit.empty() ? "" : " of ", n->unit, n->low,
                       n->high, n->automatic ? ", or \"auto\"" : "");
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
      return n->unit.empty() ? "1" : std::string(n->unit);
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
  if (const auto* i = std::get_if<Key::Integer>(&key.kind)) return fmt::format("{}", i->field(s));
  if (const auto* c = std::get_if<Key::Choice>(&key.kind))
    return fmt::format("\"{}\"", c->names[static_cast<std::size_t>(c->get(scenario))]);
  if (const auto* b = std::get_if<Key::Switch>(&key.kind)) return b->field(s) ? "true" : "false";
  if (const auto* f = std::get_if<Key::File>(&key.kind)) return toml_text(f->field(s));
  return toml_text(std::get<Key::Text>(key.kind).field(s));
}

}  // namespace trunk
