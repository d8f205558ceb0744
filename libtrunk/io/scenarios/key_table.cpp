#include "math/units.hpp"
#include "scenarios/keys.hpp"

namespace trunk {
namespace {

using Key = ScenarioKey;
constexpr double mm = m_per_mm, ml = m3_per_ml, ms = s_per_ms, one = 1.0;

template <std::size_t Knot>
double& shape_knot(Scenario& s) {
  return s.activation.shape[Knot];
}

std::vector<Key> make_keys() {
  const auto number = [](auto path, auto unit, double to_si, double low, double high, auto field,
                         auto meaning) {
    return Key{path, meaning, Key::Number{unit, to_si, low, high, field}};
  };
  const auto of_lung = [](Key key) {
    key.left_out = [](const Scenario& s) { return !s.lung_acts; };
    key.when_read = [](Scenario& s) { s.lung_acts = true; };
    return key;
  };
  return {
      {"title", "name of this scenario", Key::Text{[](Scenario& s) -> std::string& { return s.title; }}},

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
      {"geometry.tendon_border_fraction",
       "distance of the border of the central tendon from the middle, as a fraction of the half-axes",
       Key::Number{"", one, 0.65, 0.95, [](Scenario& s) -> double& { return s.geometry.tendon_border_size; }},
       [](const Scenario& s) { return s.geometry.tendon_border_size == TrunkGeometry().tendon_border_size; }},
      {"geometry.resolution",
       "particles along a length, as a multiple of the 113-particle mesh; higher needs a shorter time step",
       Key::Integer{1, 16, [](Scenario& s) -> int& { return s.geometry.resolution; }}},
      {"geometry.pml",
       "file of a trunk that replaces the parametric one and its geometry keys; \"\": no file",
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
          "stiffness of the abdominal wall, as a multiple of the diaphragm muscle"),

      number(
          "tissue.particle_mass_kg", "kg", one, 1e-6, 100,
          [](Scenario& s) -> double& { return s.tissue.particle_mass; }, "mass of every particle"),
      number(
          "tissue.tendon_stiffness_factor", "", one, 0, 1e4,
          [](Scenario& s) -> double& { return s.tissue.tendon_factor; },
          "stiffness of the central tendon, as a multiple of the diaphragm muscle"),
      number(
          "tissue.held_stiffness_factor", "", one, 0, 100,
          [](Scenario& s) -> double& { return s.tissue.held_stiffness; },
          "stiffness of held particles of abdomen and diaphragm, as a multiple of their own elasticity; 2 "
          "makes results converge faster with the resolution; a sheet finds its own"),
      {"tissue.elasticity",
       "how the stiffness of a particle follows from the mesh: each ring alike (the paper's), or as a sheet, "
       "whose results do not depend on the triangles",
       Key::Choice{{"ring", "sheet"},
                   [](Scenario& s, int i) { s.tissue.elasticity = static_cast<ElasticLaw>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.tissue.elasticity); }},
       [](const Scenario& s) { return s.tissue.elasticity == ElasticLaw::ring; }},
      {"tissue.reaction", "how the neighbours balance shape-memory forces",
       Key::Choice{{"variational", "published"},
                   [](Scenario& s, int i) { s.reaction = static_cast<Reaction>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.reaction); }}},
      {"tissue.fibres", "where the muscle fibres end; they begin at the costal insertion",
       Key::Choice{{"tendon_border", "apposition_top"},
                   [](Scenario& s, int i) { s.tissue.fibre_end = static_cast<FibreEnd>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.tissue.fibre_end); }}},
      {"tissue.ribs", "rib cage: holds the costal insertion and keeps the zone of apposition inside",
       Key::Switch{[](Scenario& s) -> bool& { return s.tissue.ribs; }}},
      number(
          "tissue.rib_friction", "", one, 0, 10, [](Scenario& s) -> double& { return s.tissue.rib_friction; },
          "Coulomb's coefficient between rib cage and zone of apposition"),
      number(
          "tissue.membrane_stiffness_N_per_m", "N_per_m", one, 0, 1e6,
          [](Scenario& s) -> double& { return s.tissue.membrane_stiffness; },
          "resistance to stretch along the edges of abdomen and diaphragm; 0: none, as in the paper"),

      {"tissue.damping",
       "what shares the damping: every particle has as much, or in proportion to its area, so that it does "
       "not "
       "depend on the triangles",
       Key::Choice{{"particle", "area"},
                   [](Scenario& s, int i) { s.tissue.damping = static_cast<DampingBy>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.tissue.damping); }},
       [](const Scenario& s) { return s.tissue.damping == DampingBy::particle; }},

      {"paralysis.side", "hemidiaphragm whose fibres do not contract",
       Key::Choice{{"none", "right", "left", "both"},
                   [](Scenario& s, int i) { s.tissue.paralysed = static_cast<Side>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.tissue.paralysed); }}},
      number(
          "paralysis.stiffness_factor", "", one, 0, 100,
          [](Scenario& s) -> double& { return s.tissue.paralysed_stiffness; },
          "elasticity of the paralysed half, as a fraction of the healthy one"),

      number(
          "activation.onset_s", "s", one, -1, 60, [](Scenario& s) -> double& { return s.activation.onset_s; },
          "start of the contraction; below 0: before the simulation starts"),
      number(
          "activation.rise_s", "s", one, 1e-3, 60, [](Scenario& s) -> double& { return s.activation.rise_s; },
          "linear rise to 1"),
      number(
          "activation.fast_fall_s", "s", one, 1e-3, 60,
          [](Scenario& s) -> double& { return s.activation.fast_fall_s; },
          "fall after the peak, the important decrease of the paper"),
      number(
          "activation.fast_fall_level", "", one, 0, 1,
          [](Scenario& s) -> double& { return s.activation.fast_fall_level; },
          "activation at the end of the fast fall"),
      number(
          "activation.slow_fall_s", "s", one, 1e-3, 60,
          [](Scenario& s) -> double& { return s.activation.slow_fall_s; },
          "fall to 0, the normal decrease of the paper"),
      number("activation.shape_rise_1", "", one, 0, 100, shape_knot<0>,
             "activation at 1/6 of the rise, as a multiple of the straight line's"),
      number("activation.shape_rise_2", "", one, 0, 100, shape_knot<1>,
             "activation at 2/6 of the rise, as a multiple of the straight line's"),
      number("activation.shape_rise_3", "", one, 0, 100, shape_knot<2>,
             "activation at 3/6 of the rise, as a multiple of the straight line's"),
      number("activation.shape_rise_4", "", one, 0, 100, shape_knot<3>,
             "activation at 4/6 of the rise, as a multiple of the straight line's"),
      number("activation.shape_rise_5", "", one, 0, 100, shape_knot<4>,
             "activation at 5/6 of the rise, as a multiple of the straight line's"),
      number("activation.shape_fast_fall_1", "", one, 0, 100, shape_knot<5>,
             "activation at 1/2 of the fast fall, as a multiple of the straight line's"),
      number("activation.shape_slow_fall_1", "", one, 0, 100, shape_knot<6>,
             "activation at 1/4 of the slow fall, as a multiple of the straight line's"),
      number("activation.shape_slow_fall_2", "", one, 0, 100, shape_knot<7>,
             "activation at 2/4 of the slow fall, as a multiple of the straight line's"),
      number("activation.shape_slow_fall_3", "", one, 0, 100, shape_knot<8>,
             "activation at 3/4 of the slow fall, as a multiple of the straight line's"),
      number(
          "activation.period_s", "s", one, 0, 600,
          [](Scenario& s) -> double& { return s.activation.period_s; },
          "the pattern repeats after this time; 0: it occurs once, or with each breath if breathing repeats"),

      of_lung(number(
          "lung.elastance_cmH2O_per_L", "cmH2O_per_L", Pa_per_cmH2O / m3_per_litre, 0, 1000,
          [](Scenario& s) -> double& { return s.parameters.lung_elastance; },
          "recoil of the lung; it acts once a scenario has a [lung] or an [airway]")),
      of_lung(number(
          "lung.resistance_cmH2O_s_per_L", "cmH2O_s_per_L", Pa_per_cmH2O / m3_per_litre, 0, 1000,
          [](Scenario& s) -> double& { return s.parameters.resistance; },
          "resistance of airway and lung tissue to flow")),
      of_lung({"airway.pressure_cmH2O", "pressure at the mouth or of a ventilator, above that of the room",
               Key::Course{"cmH2O", Pa_per_cmH2O, -200, 200,
                           [](Scenario& s) -> PiecewiseLinear& { return s.pleura.airway_pressure; }}}),
      of_lung(number(
          "airway.tube_resistance_cmH2O_s_per_L", "cmH2O_s_per_L", Pa_per_cmH2O / m3_per_litre, 0, 1000,
          [](Scenario& s) -> double& { return s.pleura.tube_resistance; },
          "resistance of a tube or mask between that pressure and the airway")),

      number(
          "time.duration_s", "s", one, 1e-3, 3600, [](Scenario& s) -> double& { return s.time.duration_s; },
          "how long to simulate"),
      {"time.start",
       "how the breath starts: with everything at rest, or in breathing that goes on (periodic)",
       Key::Choice{{"rest", "periodic"},
                   [](Scenario& s, int i) {
                     s.time.start = static_cast<Start>(i);
                     s.start_given = true;
                   },
                   [](const Scenario& s) { return static_cast<int>(s.time.start); }},
       [](const Scenario& s) { return s.time.start == Start::rest && !s.start_given; }},
      {"time.dt_ms", "time step; auto: the longest with lung volumes within 0.1 % of those at short steps",
       Key::Number{"ms", ms, 1e-4, 1000, [](Scenario& s) -> double& { return s.time.dt_s; },
                   [](Scenario& s) -> bool& { return s.automatic_step; }}},
      {"time.damping", "velocity on which damping acts in a step: at its end, or the mean of both ends",
       Key::Choice{{"implicit", "centred"},
                   [](Scenario& s, int i) { s.time.damping = static_cast<Damping>(i); },
                   [](const Scenario& s) { return static_cast<int>(s.time.damping); }}},
      number(
          "time.frame_every_ms", "ms", ms, 0, 1e6, [](Scenario& s) -> double& { return s.frame_every_s; },
          "time between stored frames; 0: no frames, and curves every 10 ms"),
  };
}

}  // namespace

std::span<const ScenarioKey> scenario_keys() {
  static const std::vector<Key> keys = make_keys();
  return keys;
}

}  // namespace trunk
