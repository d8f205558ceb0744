#include "dynamics/stability.hpp"

#include <algorithm>
#include <limits>

#include "dynamics/step.hpp"

namespace trunk {
namespace {

using Field = std::vector<Vec3d>;

double length(const Field& field) {
  double sum = 0.0;
  for (const Vec3d& a : field) sum += dot(a, a);
  return std::sqrt(sum);
}

/// Returns a direction with a part along every mode. Any fixed pattern without symmetry is good.
Field uneven_field(const Model& model) {
  Field field;
  for (std::size_t i = 0; i < model.particles(); ++i) {
    const double a = static_cast<double>(i) + 1.0;
    field.push_back(
        scaled(model.mobility[i], Vec3d{std::sin(12.9 * a), std::sin(78.2 * a), std::sin(37.7 * a)}));
  }
  return field;
}

/// Returns the accelerations per metre along `field`, with the sign of a stiffness: -M^-1 (dF/dx) field.
Field stiffness_times(const Model& model, const Parameters<double>& parameters, const Field& field,
                      Workspace<double>& w) {
  const double step_m = 1e-6;
  Field result(field.size());
  for (const double side : {1.0, -1.0}) {
    State<double> state = rest_state<double>(model);
    for (std::size_t i = 0; i < field.size(); ++i) state.position[i] += (side * step_m) * field[i];
    state.previous = state.position;  // nothing flows
    state.lung_gain = volume_of_fans<double>(w.lung_fans, state.position) - w.lung_rest;
    calc_forces(model, parameters, 1.0, state, w);
    for (std::size_t i = 0; i < field.size(); ++i)
      result[i] -= scaled(model.mobility[i], (side / (2.0 * step_m * model.mass[i])) * w.force[i]);
  }
  return result;
}

double highest_squared_frequency(const Model& model, const Parameters<double>& parameters) {
  Workspace<double> w = make_workspace(model, parameters, 1.0);
  Field field = uneven_field(model);
  double squared = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double size = length(field);
    if (size == 0.0) return 0.0;
    for (Vec3d& a : field) a = (1.0 / size) * a;
    field = stiffness_times(model, parameters, field, w);
    const double next = length(field);
    const bool settled = std::abs(next - squared) <= 1e-6 * next;
    squared = next;
    if (settled) break;
  }
  return squared;
}

}  // namespace

double stable_time_step(const Model& model, const Parameters<double>& parameters, Damping damping) {
  const double squared = highest_squared_frequency(model, parameters);
  if (squared <= 0.0) return std::numeric_limits<double>::infinity();
  if (damping == Damping::centred) return 2.0 / std::sqrt(squared);
  double rate = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.particles(); ++i)
    rate = std::min(rate, parameters.damping * model.damping_weight[i] / model.mass[i]);
  return (rate + std::sqrt(rate * rate + 4.0 * squared)) / squared;
}

}  // namespace trunk
