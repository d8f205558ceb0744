#include "compartment/compartment_model.hpp"

#include <cmath>

#include "dynamics/simulate.hpp"
#include "linear_algebra/decompositions.hpp"

namespace trunk {

TrunkAsCompartment as_compartment(const Recoil& recoil, const std::optional<Pleura>& pleura) {
  constexpr double usual = 25.0, least = 5.0;
  const double factor = recoil.time_factor > least ? recoil.time_factor : usual;
  const double relaxation = TrunkAsCompartment::between * factor;
  TrunkAsCompartment trunk{relaxation, recoil.gain, recoil.gain, relaxation};
  trunk.abdominal = recoil.abdominal;
  trunk.wall.measured_at = recoil.abdomen_factor;
  if (!pleura) return trunk;
  trunk.elastance = recoil.elastance;
  trunk.tube_resistance = pleura->tube_resistance;
  trunk.airway_pressure = pleura->airway_pressure;
  return trunk;
}

WallFactor wall_factor(const Recoil& recoil, const Recoil& more) {
  WallFactor wall{recoil.abdomen_factor, 0.0, 0.0, 0.0};
  const double apart = std::log(more.abdomen_factor / recoil.abdomen_factor);
  const auto power = [&](double from, double to) { return std::log(to / from) / apart; };
  // Without a pleura the elastance is not measured; the damping does not know the wall, and tells it.
  wall.elastance = recoil.elastance > 0.0 ? power(recoil.elastance, more.elastance)
                                          : power(more.time_factor, recoil.time_factor);
  wall.gain = power(recoil.gain, more.gain) + wall.elastance;
  wall.abdominal = power(recoil.abdominal, more.abdominal);
  return wall;
}

namespace {

/// Returns the volume that the airway's pressure would hold at times, m3.
std::vector<double> pushed_m3(const TrunkAsCompartment& trunk, const Parameters<double>& p,
                              std::span<const double> time_s) {
  std::vector<double> volume;
  for (const double t : time_s) volume.push_back(trunk.airway_pressure(t) / trunk.respiratory_elastance(p));
  return volume;
}

}  // namespace

CompartmentBreath breath_of(const TrunkAsCompartment& trunk, const Candidate& c, const TimeGrid& grid,
                            std::span<const double> time_s) {
  const Compartment compartment = trunk.of(c.parameters);
  CompartmentBreath breath = compartment_breath(compartment, c.activation, grid, time_s);
  if (trunk.airway_pressure.empty()) return breath;
  const CompartmentBreath by_airway =
      driven_breath(compartment.time_constant_s, pushed_m3(trunk, c.parameters, time_s), grid, time_s);
  for (std::size_t i = 0; i < breath.delta_v.size(); ++i) breath.delta_v[i] += by_airway.delta_v[i];
  breath.above_relaxation_m3 += by_airway.above_relaxation_m3;
  return breath;
}

SeenBreath seen(const TrunkAsCompartment& trunk, const Candidate& c, const TimeGrid& grid,
                const MeasuredCurve& measured) {
  const CompartmentBreath breath = breath_of(trunk, c, grid, measured.time_s);
  SeenBreath found{mapped(breath.delta_v), {}, {}, {}, {}};
  if (measured.beside.empty()) return found;
  const Parameters<double>& p = c.parameters;
  const Compartment compartment = trunk.of(p);
  found.activation = activation_at(measured, c.activation, grid);
  Eigen::VectorXd pushed = Eigen::VectorXd::Zero(found.delta_v.size());
  if (!trunk.airway_pressure.empty()) pushed = mapped(pushed_m3(trunk, p, measured.time_s));
  Eigen::VectorXd flow = compartment.gain_m3 * found.activation + pushed - found.delta_v;
  flow = (flow.array() - breath.above_relaxation_m3) / compartment.time_constant_s;
  const auto changed = [](const Eigen::VectorXd& course) {  // pressures are changes from the start
    return Eigen::VectorXd(course.array() - course[0]);
  };
  found.abdominal_Pa =
      trunk.abdominal_elastance(p) * found.delta_v + trunk.abdominal_flow * p.damping * changed(flow);
  found.pleural_Pa = trunk.respiratory_elastance(p) * changed(pushed) - p.lung_elastance * found.delta_v -
                     (p.resistance + trunk.tube_resistance) * changed(flow);
  found.right_dome_m = -trunk.right_descent * found.delta_v;
  return found;
}

void calibrate(const Candidate& c, const BreathCurves& curves, const TimeGrid& grid,
               TrunkAsCompartment& trunk) {
  const Eigen::VectorXd volume = mapped(curves.delta_v), pressure = mapped(curves.abdominal_Pa);
  const Eigen::Index n = volume.size();
  Eigen::MatrixXd courses = Eigen::MatrixXd::Zero(n, 2);
  courses.col(0).segment(1, n - 2) = (volume.tail(n - 2) - volume.head(n - 2)) / (2.0 * grid.dt_s);
  courses.col(1).setOnes();
  const Eigen::VectorXd recoil = trunk.abdominal_elastance(c.parameters) * volume;
  trunk.abdominal_flow = (pseudo_inverse(courses) * (pressure - recoil))[0] / c.parameters.damping;
  trunk.right_descent = -volume.dot(mapped(curves.right_dome_m)) / volume.squaredNorm();
}

Eigen::VectorXd CompartmentModel::plain(const Candidate& c) const {
  const SeenBreath breath = seen(trunk_, c, grid_, curve_);
  return as_measured(curve_, breath, breath);
}

void CompartmentModel::correct_at(const Candidate& candidate, const Eigen::VectorXd& values) {
  missed_ = values - plain(candidate);
}

std::vector<LedgerEntry> CompartmentModel::at(const std::vector<Candidate>& candidates) {
  const auto completed = static_cast<std::int32_t>(Ending::Status::completed);
  std::vector<LedgerEntry> entries;
  for (const Candidate& c : candidates) {
    const Eigen::VectorXd values = plain(c);
    LedgerEntry entry{completed, grid_.duration_s, 0.0, {values.data(), values.data() + values.size()}};
    for (Eigen::Index i = 0; i < missed_.size(); ++i) entry.values[static_cast<std::size_t>(i)] += missed_[i];
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace trunk
