#include "dynamics/lead.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace trunk {
namespace {

/// Returns the longest time in which a swing fades to 1 / e, s.
double fading_s(const Model& model, double damping) {
  double slowest = 0.0;
  for (std::size_t i = 0; i < model.particles(); ++i)
    if (model.damping_weight[i] > 0.0) slowest = std::max(slowest, model.mass[i] / model.damping_weight[i]);
  return 2.0 * slowest / damping;
}

/// Returns how much longer the volume takes to fade than without lung and airway, s. The volume fades as that
/// of one compartment. Of its numbers, stiffness is at least that at the measured abdominal factor times
/// min(1, f / f0). What a constant pressure in the airway holds is absent at the beginning, and has to be
/// forgotten too, down to the same part of a small breath.
double longer_s(const Recoil& r, const Parameters<double>& p, const Pleura& pleura) {
  constexpr double forgotten = 11.0, small_breath = 0.1e-3;  // m3
  const double softer = std::min(1.0, p.abdomen_factor / r.abdomen_factor);
  const double elastance = softer * r.elastance * p.elasticity + p.lung_elastance;
  const double tissue_s = r.time_factor * p.damping / p.elasticity / softer;
  const double resistance =
      softer * r.elastance * p.elasticity * tissue_s + p.resistance + pleura.tube_resistance;
  double most_Pa = 0.0;
  for (const auto& event : pleura.airway_pressure.events())
    most_Pa = std::max(most_Pa, std::abs(event.value));
  const double time_s = resistance / elastance;
  return std::max(0.0, forgotten * (time_s - tissue_s)) +
         time_s * std::log1p(most_Pa / elastance / small_breath);
}

/// Returns true if the breath's course displaces something, other than by forces.
bool displaces(const Model& model) {
  return !model.abdomen.target.empty() || !model.imposed_displacements.empty() ||
         std::any_of(model.bodies.begin(), model.bodies.end(),
                     [](const RigidBody& body) { return body.motion == RigidBody::Motion::driven; });
}

}  // namespace

double lead_s(const Model& model, const Parameters<double>& p) {
  constexpr double times = 10.0;  // exp(-10) is 5e-5
  if (!model.recoil)
    throw std::logic_error("breathing that repeats needs a model whose recoil has been measured");
  const Recoil& r = *model.recoil;
  const double memory_s = r.memory * p.damping / p.elasticity;
  double bound_s = memory_s * std::max(1.0, r.abdomen_factor / p.abdomen_factor);
  if (model.pleura) bound_s += longer_s(r, p, *model.pleura);
  return std::max(bound_s, times * fading_s(model, p.damping));
}

int lead_steps(const Model& model, const Parameters<double>& parameters, const TimeGrid& grid) {
  if (grid.start == Start::rest) return 0;
  const double needed_s = lead_s(model, parameters);
  const double given_s = needed_s < longest_lead_s ? needed_s : longest_lead_s;  // NaN takes the longest
  if (!displaces(model)) return static_cast<int>(std::ceil(given_s / grid.dt_s));
  const double breaths = std::ceil(given_s / grid.duration_s);
  return static_cast<int>(std::floor(breaths * grid.duration_s / grid.dt_s + 0.5));
}

double time_in_breath_s(const TimeGrid& grid, int step) noexcept {
  const double time_s = step * grid.dt_s;  // no accumulated round-off
  return step < 0 ? time_s - grid.duration_s * std::floor(time_s / grid.duration_s) : time_s;
}

}  // namespace trunk
