#include "compartment/compartment_model.hpp"

#include <Eigen/QR>

#include "dynamics/simulate.hpp"

namespace trunk {
namespace {

Eigen::VectorXd mapped(const std::vector<double>& values) {
  return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

TrunkAsCompartment as_compartment(const Recoil& recoil, const std::optional<Pleura>& pleura) {
  constexpr double usual = 25.0, least = 5.0;
  const double factor = recoil.time_factor > least ? recoil.time_factor : usual;
  const double relaxation = TrunkAsCompartment::between * factor;
  return {relaxation,
          recoil.gain,
          recoil.gain,
          relaxation,
          pleura ? recoil.elastance : 0.0,
          pleura ? pleura->tube_resistance : 0.0};
}

SeenBreath seen(const TrunkAsCompartment& trunk, const Candidate& c, const TimeGrid& grid,
                const MeasuredCurve& measured) {
  const Compartment compartment = trunk.of(c.parameters);
  const CompartmentBreath breath = compartment_breath(compartment, c.activation, grid, measured.time_s);
  SeenBreath found{mapped(breath.delta_v), {}, {}, {}};
  if (measured.beside.empty()) return found;
  found.activation = activation_at(measured, c.activation, grid);
  const Eigen::VectorXd above = found.delta_v.array() + breath.above_relaxation_m3;
  Eigen::VectorXd flow = (compartment.gain_m3 * found.activation - above) / compartment.time_constant_s;
  flow.array() -= flow[0];  // pressures are changes from the start of the breath
  found.abdominal_Pa = trunk.abdominal * c.parameters.elasticity * found.delta_v +
                       trunk.abdominal_flow * c.parameters.damping * flow;
  found.right_dome_m = -trunk.right_descent * found.delta_v;
  return found;
}

void calibrate(const Candidate& c, const BreathCurves& curves, const TimeGrid& grid,
               TrunkAsCompartment& trunk) {
  const Eigen::VectorXd volume = mapped(curves.delta_v), pressure = mapped(curves.abdominal_Pa);
  const Eigen::Index n = volume.size();
  Eigen::MatrixXd courses = Eigen::MatrixXd::Zero(n, 3);
  courses.col(0) = volume;
  courses.col(1).segment(1, n - 2) = (volume.tail(n - 2) - volume.head(n - 2)) / (2.0 * grid.dt_s);
  courses.col(2).setOnes();
  const Eigen::VectorXd found = courses.colPivHouseholderQr().solve(pressure);
  trunk.abdominal = found[0] / c.parameters.elasticity;
  trunk.abdominal_flow = found[1] / c.parameters.damping;
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
