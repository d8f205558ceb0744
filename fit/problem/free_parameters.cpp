#include "problem/free_parameters.hpp"

#include "math/units.hpp"
#include "text/edit_distance.hpp"

#include <fmt/format.h>

namespace trunk {
namespace {

using Group = FreeParameter::Group;
using Scale = FreeParameter::Scale;

// Priors (our choice): how exactly a trace gives the timing, and how far a knot may leave its line.
constexpr double Pa_m3_per_unit = Pa_per_cmH2O / m3_per_litre;
constexpr double timing_prior = 1.5, onset_prior_s = 0.3, shape_prior = 1.0;

template <std::size_t Knot>
FreeParameter knot(std::string_view name, std::string_view key) {
  return {name,
          "1",
          key,
          0.02,
          20.0,
          Group::shape,
          [](Candidate& c) -> double& { return c.activation.shape[Knot]; },
          Scale::factor,
          shape_prior};
}

}  // namespace

std::span<const FreeParameter> free_parameters() {
  static const FreeParameter all[] = {
      // Volume gives no scale of forces, so these bounds are wide: recoil times of 5 ms to 24 s.
      {"k_elasticity", "N/m", "parameters.k_elasticity_N_per_m", 20.0, 1e5, Group::mechanics,
       [](Candidate& c) -> double& { return c.parameters.elasticity; }},
      {"k_muscle", "N/m", "parameters.k_muscle_N_per_m", 1e-3, 1e5, Group::mechanics,
       [](Candidate& c) -> double& { return c.parameters.muscle; }},
      {"damping", "N s/m", "parameters.damping_N_s_per_m", 0.5, 500.0, Group::mechanics,
       [](Candidate& c) -> double& { return c.parameters.damping; }},
      {"abdomen_stiffness_factor", "1", "parameters.abdomen_stiffness_factor", 0.05, 20.0, Group::mechanics,
       [](Candidate& c) -> double& { return c.parameters.abdomen_factor; }},
      {"lung_elastance", "cmH2O/L", "lung.elastance_cmH2O_per_L", 0.2, 200.0, Group::mechanics,
       [](Candidate& c) -> double& { return c.parameters.lung_elastance; }, Scale::factor, 0.0,
       Pa_m3_per_unit, true},
      {"resistance", "cmH2O s/L", "lung.resistance_cmH2O_s_per_L", 0.02, 200.0, Group::mechanics,
       [](Candidate& c) -> double& { return c.parameters.resistance; }, Scale::factor, 0.0, Pa_m3_per_unit,
       true},
      {"onset", "s", "activation.onset_s", -1.0, 10.0, Group::timing,
       [](Candidate& c) -> double& { return c.activation.onset_s; }, Scale::amount, onset_prior_s},
      {"rise", "s", "activation.rise_s", 0.1, 10.0, Group::timing,
       [](Candidate& c) -> double& { return c.activation.rise_s; }, Scale::factor, timing_prior},
      {"fast_fall", "s", "activation.fast_fall_s", 0.02, 10.0, Group::timing,
       [](Candidate& c) -> double& { return c.activation.fast_fall_s; }, Scale::factor, timing_prior},
      {"slow_fall", "s", "activation.slow_fall_s", 0.02, 20.0, Group::timing,
       [](Candidate& c) -> double& { return c.activation.slow_fall_s; }, Scale::factor, timing_prior},
      {"fast_fall_level", "1", "activation.fast_fall_level", 0.01, 1.0, Group::mechanics,
       [](Candidate& c) -> double& { return c.activation.fast_fall_level; }, Scale::factor, 1.0},
      knot<0>("shape_rise_1", "activation.shape_rise_1"),
      knot<1>("shape_rise_2", "activation.shape_rise_2"),
      knot<2>("shape_rise_3", "activation.shape_rise_3"),
      knot<3>("shape_rise_4", "activation.shape_rise_4"),
      knot<4>("shape_rise_5", "activation.shape_rise_5"),
      knot<5>("shape_fast_fall_1", "activation.shape_fast_fall_1"),
      knot<6>("shape_slow_fall_1", "activation.shape_slow_fall_1"),
      knot<7>("shape_slow_fall_2", "activation.shape_slow_fall_2"),
      knot<8>("shape_slow_fall_3", "activation.shape_slow_fall_3"),
  };
  return all;
}

const FreeParameter& free_parameter(const std::string& name, const Place& at) {
  std::string names;
  std::vector<std::string> known{"timing", "shape"};
  for (const FreeParameter& p : free_parameters()) {
    if (p.name == name) return p;
    known.emplace_back(p.name);
    if (p.group != Group::shape) names += std::string(p.name) + ", ";
  }
  const std::string near = nearest_name(name, known);
  throw InputError(at, fmt::format("there is no parameter '{}' to fit", name),
                   fmt::format("one of {}timing (onset, rise and falls) or shape (shape_rise_1 to _5, "
                               "shape_fast_fall_1, shape_slow_fall_1 to _3)",
                               names),
                   near.empty() ? "" : "did you mean '" + near + "'?");
}

std::vector<std::string> parameter_names(const std::vector<std::string>& given) {
  std::vector<std::string> names;
  for (const std::string& name : given) {
    const bool timing = name == "timing", shape = name == "shape";
    if (!timing && !shape) names.emplace_back(free_parameter(name, {"--free " + name}).name);
    for (const FreeParameter& p : free_parameters())
      if ((timing && p.group == Group::timing) || (shape && p.group == Group::shape))
        names.emplace_back(p.name);
  }
  return names;
}

double value_of(const FreeParameter& parameter, const Candidate& candidate) {
  return parameter.field(const_cast<Candidate&>(candidate)) / parameter.to_si;  // the field is only read
}

void set_value(const FreeParameter& parameter, double value, Candidate& candidate) {
  parameter.field(candidate) = value * parameter.to_si;
}

}  // namespace trunk
