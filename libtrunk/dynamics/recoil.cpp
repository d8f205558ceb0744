#include "dynamics/recoil.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/kernel.hpp"
#include "dynamics/stability.hpp"
#include "dynamics/volume_curve.hpp"
#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// Removes everything that moves a model but its muscle and its elasticity.
Model undisturbed(Model model) {
  model.gravity = {};
  model.focal_forces.clear();
  model.pressures.clear();
  model.imposed_displacements.clear();  // the particles stay where they are
  model.abdomen.target = {};
  if (model.pleura) model.pleura = Pleura{};
  for (RigidBody& body : model.bodies)
    if (body.motion == RigidBody::Motion::driven) body.motion = RigidBody::Motion::fixed;
  return model;
}

bool has_muscle(const Model& model) {
  return std::any_of(model.fibres.begin(), model.fibres.end(),
                     [](const Fibre& fibre) { return fibre.activity > 0.0; });
}

/// A model that is held and released.
class Measurement {
 public:
  Measurement(const Model& model, Parameters<double> parameters)
      : model_(model),
        parameters_(parameters),
        unit_s_(parameters.damping / parameters.elasticity),
        state_(rest_state<double>(model)) {
    constexpr double part_of_bound = 0.5, part_of_unit = 2.0;  // a unit is about 1/25 of the recoil time
    const double bound_s = part_of_bound * stable_time_step(model, parameters, Damping::centred);
    dt_s_ = std::min(bound_s, part_of_unit * unit_s_);
    workspace_ = make_workspace(model, parameters, dt_s_, Damping::centred);
  }

  /// Lets the muscle pull with a multiple of k_muscle until nothing moves, and returns the volume above rest.
  double hold(double strength) {
    constexpr double still = 1e-5;  // of what moved; particles that come and go at the ribs may move more
    double before_m = 0.0;
    while (steps_ < most_steps) {
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for (int n = 0; n < block; ++n) {
        step(strength);
        least = std::min(least, volume());
        most = std::max(most, volume());
      }
      const double now_m = farthest_m();
      const bool holds = most - least <= 10.0 * still * std::abs(most);
      if (holds && std::abs(now_m - before_m) <= still * now_m) return volume();
      before_m = now_m;
    }
    not_still();
  }

  /// Returns the abdominal pressure above rest, Pa.
  double abdominal_Pa() const noexcept { return abdominal_Pa_; }

  /// Lets the muscle go, and measures until everything is back at rest. gain is left out.
  Recoil release() {
    constexpr double back = 1e-4, forgotten = 2e-5;
    const double held = volume(), held_m = farthest_m();
    double sum = 0.5 * held;  // the trapezoidal rule
    int remembered = 0;
    for (int n = 1; n - remembered < block || farthest_m() > back * held_m; ++n) {
      step(0.0);
      const double now = volume();
      sum += now;
      if (std::abs(now) > forgotten * std::abs(held)) remembered = n;
      if (n > most_steps) not_still();
    }
    // The forces at the start of a step act from half a step before it: so much earlier the muscle lets go.
    sum += 0.5 * held;
    return {sum / held * dt_s_ / unit_s_, 0.0, (remembered + 1) * dt_s_ / unit_s_,
            parameters_.abdomen_factor};
  }

 private:
  static constexpr int block = 16, most_steps = 200'000;

  void step(double strength) {
    Parameters<double> p = parameters_;
    p.muscle *= strength;
    const StepReport<double> report = kernel().step(model_, p, 1.0, state_, workspace_);
    if (!report.ok) not_still();
    abdominal_Pa_ = report.pressure_Pa;
    ++steps_;
  }

  double volume() const { return state_.lung_gain; }

  double farthest_m() const {
    double most = 0.0;
    for (std::size_t i = 0; i < model_.particles(); ++i)
      most = std::max(most, norm(state_.position[i] - model_.rest[i]));
    return most;
  }

  [[noreturn]] static void not_still() {
    throw InputError({},
                     "the trunk does not come to rest after a contraction, so its breathing cannot repeat",
                     "a trunk whose tissue springs back", "start = \"rest\" in [time], or a stiffer trunk");
  }

  const Model& model_;
  Parameters<double> parameters_;
  double unit_s_, dt_s_ = 0.0;
  State<double> state_;
  Workspace<double> workspace_;
  double abdominal_Pa_ = 0.0;  // at the end of the last step
  int steps_ = 0;
};

/// Returns Recoil::elastance. The muscle rests, and a pressure in the airway holds `wanted`, m3.
double measure_elastance(Model model, const Parameters<double>& p, double wanted) {
  constexpr double usual = 500.0;  // 1/m4, that of the default trunk
  const auto hold = [&](double pressure_Pa) {
    model.pleura->airway_pressure = PiecewiseLinear({{0.0, pressure_Pa}}, pressure_Pa);
    return Measurement(model, p).hold(0.0);
  };
  const double first_Pa = usual * p.elasticity * wanted;
  const double second_Pa = first_Pa * wanted / std::max(hold(first_Pa), 0.1 * wanted);
  return second_Pa / (p.elasticity * hold(second_Pa));
}

}  // namespace

Recoil measure_recoil(const Model& given, const Parameters<double>& parameters) {
  constexpr double part_of_lung = 0.05, first_ratio = 0.0034;  // the ratio that holds it in the default trunk
  Model model = undisturbed(given);
  const bool paralysed = !has_muscle(model);
  if (paralysed)
    for (Fibre& fibre : model.fibres) fibre.activity = 1.0;
  Parameters<double> p = parameters;
  p.muscle = first_ratio * p.elasticity;
  p.lung_elastance = p.resistance = 0.0;
  Measurement measurement(model, p);
  const double wanted = part_of_lung * enclosed_volume<double>(model.lung, model.rest);
  const double strength = wanted / std::max(measurement.hold(1.0), 0.1 * wanted);
  const double held = measurement.hold(strength);
  const double abdominal = measurement.abdominal_Pa() / (p.elasticity * held);
  Recoil recoil = measurement.release();
  recoil.abdominal = abdominal;
  if (!paralysed) recoil.gain = held / (strength * first_ratio);
  if (model.pleura) recoil.elastance = measure_elastance(model, p, wanted);
  return recoil;
}

double recoil_time_s(const Recoil& r, const Parameters<double>& p, const std::optional<Pleura>& pleura) {
  if (!pleura) return r.time_factor * p.damping / p.elasticity;
  return (r.elastance * r.time_factor * p.damping + p.resistance + pleura->tube_resistance) /
         (r.elastance * p.elasticity + p.lung_elastance);
}

Recoil measure_recoil_for_leads(Model model) {
  // Those of the shipped scenarios, but twice as damped: inertia, which shortens the memory, counts little.
  const Parameters<double> parameters{4000.0, 0.0, 40.0, model.pleura ? 0.3 : 0.8};
  model.membrane.clear();
  return measure_recoil(model, parameters);
}

}  // namespace trunk
