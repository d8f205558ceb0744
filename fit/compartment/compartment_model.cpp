#include "compartment/compartment_model.hpp"

#include "dynamics/simulate.hpp"

namespace trunk {

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

std::vector<double> CompartmentModel::plain(const Candidate& c) const {
  return compartment_breath(trunk_.of(c.parameters), c.activation, grid_, curve_.time_s).delta_v;
}

void CompartmentModel::correct_at(const Candidate& candidate, const Eigen::VectorXd& volumes) {
  missed_ = plain(candidate);
  for (std::size_t i = 0; i < missed_.size(); ++i)
    missed_[i] = volumes[static_cast<Eigen::Index>(i)] - missed_[i];
}

std::vector<LedgerEntry> CompartmentModel::at(const std::vector<Candidate>& candidates) {
  const auto completed = static_cast<std::int32_t>(Ending::Status::completed);
  std::vector<LedgerEntry> entries;
  for (const Candidate& c : candidates) {
    LedgerEntry entry{completed, grid_.duration_s, 0.0, plain(c)};
    for (std::size_t i = 0; i < missed_.size(); ++i) entry.values[i] += missed_[i];
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace trunk
