#include "problem/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "errors/input_error.hpp"
#include "linear_algebra/decompositions.hpp"
#include "problem/trunk_model.hpp"

namespace trunk {

Objective::Objective(VolumeModel& model, const TimeGrid& grid, const SearchSpace& space,
                     const MeasuredCurve& measured, Knowledge knowledge)
    : volumes_(model), grid_(grid), space_(space), curve_(measured), knowledge_(std::move(knowledge)) {
  if (!measured.is_tidal_volume() &&
      (measured.time_s.empty() || measured.time_s.size() != measured.delta_v.size()))
    throw InputError({}, "the measured curve has no samples", "a volume at each time");
  if (!measured.time_s.empty() && measured.time_s.back() > grid.duration_s + grid.dt_s)
    throw InputError({},
                     fmt::format("the measured curve lasts {:.3f} s, the simulation {:.3f} s",
                                 measured.time_s.back(), grid.duration_s),
                     "a simulation as long as the curve");
  blocks_ = blocks_of(measured);
  measured_ = values_of(measured);
  deviation_ = sample_deviation(measured);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {  // a deviation is the same for all of such a block
    const Eigen::MatrixXd courses = nuisance_of(measured, b);
    nuisance_.push_back(courses.cols() > 0 ? orthonormal_basis(courses) : courses);
  }
}

void Objective::reweigh(const std::vector<double>& deviations) {
  for (std::size_t b = 1; b < blocks_.size(); ++b)
    deviation_.segment(blocks_[b].first, blocks_[b].count).setConstant(deviations[b - 1]);
}

LeastSquares Objective::problem() {
  return {[this](const std::vector<Eigen::VectorXd>& some) { return outcomes(some); }, space_.lower(),
          space_.upper(), [this](const Eigen::VectorXd& x) { return slopes(x); }};
}

void Objective::use_loss(Loss loss, double scale) {
  loss_ = loss;
  loss_scale_ = scale;
}

Eigen::MatrixXd Objective::whitened(const Eigen::MatrixXd& values) const {
  Eigen::MatrixXd rows = deviation_.cwiseInverse().asDiagonal() * values;
  for (std::size_t b = 1; b < blocks_.size(); ++b) {
    if (nuisance_[b].cols() == 0) continue;
    auto part = rows.middleRows(blocks_[b].first, blocks_[b].count);
    part -= nuisance_[b] * Eigen::MatrixXd(nuisance_[b].transpose() * part);
  }
  if (rho_ == 0.0) return rows;
  const Eigen::Index later = blocks_.front().count - 1;
  const Eigen::MatrixXd fresh =
      (rows.middleRows(1, later) - rho_ * rows.topRows(later)) / std::sqrt(1.0 - rho_ * rho_);
  rows.middleRows(1, later) = fresh;
  return rows;
}

/// Returns all residuals that do not come from the curve.
Eigen::VectorXd Objective::known(const Eigen::VectorXd& x) const {
  Eigen::VectorXd priors = space_.prior_residuals(x);
  if (knowledge_.empty()) return priors;
  const Candidate candidate = space_.decode(x);
  Eigen::VectorXd all(priors.size() + static_cast<Eigen::Index>(knowledge_.size()));
  all.head(priors.size()) = priors;
  for (std::size_t k = 0; k < knowledge_.size(); ++k)
    all[priors.size() + static_cast<Eigen::Index>(k)] = knowledge_[k].residual(candidate);
  return all;
}

std::vector<std::string> Objective::known_names() const {
  std::vector<std::string> names = space_.prior_names();
  for (const KnownFact& fact : knowledge_) names.push_back(fact.name);
  return names;
}

Outcome Objective::judged(const Eigen::VectorXd& x, const LedgerEntry& entry) const {
  if (entry.values.empty()) {
    const double energy = measured_.cwiseQuotient(deviation_).squaredNorm();
    const double lasted = std::clamp(entry.lasted_s / grid_.duration_s, 0.0, 1.0);
    return {std::nullopt, 100.0 * energy * (2.0 - lasted)};
  }
  const Eigen::VectorXd model = Eigen::VectorXd::Map(entry.values.data(), samples());
  const Eigen::VectorXd curve = robust_residuals(whitened(model - measured_), loss_, loss_scale_);
  const Eigen::VectorXd beside = known(x);
  Eigen::VectorXd all(curve.size() + beside.size());
  all << curve, beside;
  return {all, all.squaredNorm()};
}

std::vector<Outcome> Objective::outcomes(const std::vector<Eigen::VectorXd>& some) {
  std::vector<Candidate> candidates;
  for (const Eigen::VectorXd& x : some) candidates.push_back(space_.decode(x));
  const std::vector<LedgerEntry> found = volumes_.at(candidates);
  std::vector<Outcome> result;
  for (std::size_t i = 0; i < some.size(); ++i) {
    result.push_back(judged(some[i], found[i]));
    if (volumes_.is_simulation() && asked_.emplace(ledger_key(candidates[i]), true).second)
      evaluations_.push_back({candidates[i], result.back().objective,
                              static_cast<Ending::Status>(found[i].status), found[i].wall_s});
  }
  return result;
}

Slopes Objective::slopes(const Eigen::VectorXd& x) {
  std::vector<Eigen::Index> all(space_.size());
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  return slopes(x, all);
}

Slopes Objective::slopes(const Eigen::VectorXd& x, const std::vector<Eigen::Index>& some) {
  const Outcome here = outcomes({x}).front();
  if (!here.residuals) return std::nullopt;
  const auto coordinates = static_cast<Eigen::Index>(some.size());
  const std::vector<Candidate> all_directions = space_.directions(x);
  std::vector<Candidate> directions;
  for (const Eigen::Index i : some) directions.push_back(all_directions[static_cast<std::size_t>(i)]);
  const auto entry = volumes_.slopes(space_.decode(x), directions);
  if (!entry) {
    const LeastSquares whole = problem();
    return jacobian(with_fixed(whole, x, some), x(some), 1e-4);
  }
  if (entry->values.empty()) return std::nullopt;

  const double step = 1e-4;  // most priors are linear; for the others this is short
  const Eigen::VectorXd weight = robust_slopes(whitened(*model(x) - measured_), loss_, loss_scale_);
  Eigen::MatrixXd all(here.residuals->size(), coordinates);
  all.topRows(samples()) =
      weight.asDiagonal() * whitened(Eigen::MatrixXd::Map(entry->values.data(), samples(), coordinates));
  for (Eigen::Index i = 0; i < coordinates; ++i) {
    const Eigen::VectorXd aside = step * Eigen::VectorXd::Unit(x.size(), some[static_cast<std::size_t>(i)]);
    all.col(i).tail(all.rows() - samples()) = (known(x + aside) - known(x - aside)) / (2.0 * step);
  }
  return all;
}

std::optional<Eigen::VectorXd> Objective::model(const Eigen::VectorXd& x) {
  outcomes({x});  // enters the simulation in evaluations_
  const LedgerEntry entry = volumes_.at({space_.decode(x)}).front();
  if (entry.values.empty()) return std::nullopt;
  return Eigen::VectorXd::Map(entry.values.data(), samples());
}

int Objective::failures() const noexcept {
  return static_cast<int>(std::count_if(evaluations_.begin(), evaluations_.end(), [](const Evaluation& e) {
    return e.status != Ending::Status::completed;
  }));
}

}  // namespace trunk
