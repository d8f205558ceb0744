#include "verdict/settling.hpp"

#include <algorithm>
#include <cmath>

#include "anatomy/breath_run.hpp"
#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

Indices that_stay(const SearchSpace& space) {
  Indices some;
  for (std::size_t i = 0; i < space.size(); ++i)
    if (space.parameter(i).group == FreeParameter::Group::mechanics && space.parameter(i).name != "k_muscle")
      some.push_back(static_cast<Eigen::Index>(i));
  return some;
}

}  // namespace

Settling::Settling(const FitProblem& problem, const Estimation& estimation)
    : fit_(*estimation.local),
      volumes_(fit_.blocks.front().count),
      model_(problem.compartment, problem.grid, problem.measured),
      posterior_(model_, problem.grid, problem.space, problem.measured) {
  model_.correct_at(problem.space.decode(fit_.x), estimation.model);
  posterior_.use_correlation(problem.correlation);
  moving_ = all_but(that_stay(problem.space), problem.space.size());
  step_ = step_with(fit_.rows(Eigen::all, moving_));
  measure_axes(problem);
}

Eigen::MatrixXd Settling::step_with(const Eigen::MatrixXd& slopes) const {
  const Eigen::Index others = fit_.rows.rows() - posterior_.samples();
  Eigen::MatrixXd rows(volumes_ + others, slopes.cols());
  rows << slopes.topRows(volumes_), fit_.rows.bottomRows(others)(Eigen::all, moving_);
  return -pseudo_inverse(rows).leftCols(volumes_);
}

Eigen::VectorXd Settling::missed_at(const Eigen::VectorXd& x) const {
  constexpr double farthest = 2.0;  // in the distances at which the axes were measured
  Eigen::VectorXd missed = Eigen::VectorXd::Zero(volumes_);
  for (const Axis& a : axes_) {
    const double z = std::clamp(a.along.dot(x - fit_.x), -farthest, farthest);
    missed += z * a.odd + z * z * a.even;
  }
  return missed;
}

void Settling::measure_axes(const FitProblem& problem) {
  constexpr double deviations = 1.5, least = 0.02;  // in coordinates: nearer, straight lines are good enough
  const Indices stay = that_stay(problem.space);
  if (stay.empty()) return;
  const SymmetricEigen eigen = symmetric_eigen(fit_.covariance(stay, stay));
  std::vector<Axis> axes;
  std::vector<Candidate> candidates;
  std::vector<Eigen::VectorXd> points;
  for (Eigen::Index k = 0; k < eigen.values.size(); ++k) {
    const double reach = deviations * std::sqrt(std::max(eigen.values[k], 0.0));
    if (reach < least) continue;
    Axis axis{Eigen::VectorXd::Zero(fit_.x.size()), {}, {}};
    axis.along(stay) = eigen.vectors.col(k) / reach;
    // Where a draw that is so far along the axis is expected.
    const Eigen::VectorXd aside =
        fit_.covariance(Eigen::all, stay) * eigen.vectors.col(k) * (reach / eigen.values[k]);
    for (const double side : {1.0, -1.0}) {
      points.push_back((*this)(fit_.x + side * aside));
      candidates.push_back(problem.space.decode(points.back()));
    }
    axes.push_back(std::move(axis));
  }
  const auto breaths = summarise_breaths(problem.trunk, candidates, problem.grid);
  const auto missed = [&](std::size_t i) {
    Eigen::VectorXd trunk = posterior_.measured();
    trunk.head(volumes_) = sampled(breaths[i].delta_v, problem.grid.dt_s, problem.measured.time_s);
    const Outcome here = posterior_.problem().at(points[i]);
    const Eigen::MatrixXd whole = posterior_.whitened(trunk - posterior_.measured());
    const Eigen::VectorXd apart = whole.topRows(volumes_);
    return here.residuals ? Eigen::VectorXd(apart - here.residuals->head(volumes_))
                          : Eigen::VectorXd(0.0 * apart);
  };
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (!breaths[2 * k].ending.completed() || !breaths[2 * k + 1].ending.completed()) continue;
    const Eigen::VectorXd more = missed(2 * k), less = missed(2 * k + 1);
    axes[k].odd = 0.5 * (more - less);
    axes[k].even = 0.5 * (more + less);
    axes_.push_back(std::move(axes[k]));
  }
}

Eigen::VectorXd Settling::operator()(const Eigen::VectorXd& draw) {
  constexpr int steps = 8;
  constexpr double enough = 0.3;  // in deviations, of which the volume has about 20 independent ones
  const Eigen::VectorXd wanted =
      (fit_.residuals + fit_.rows.topRows(fit_.residuals.size()) * (draw - fit_.x)).head(volumes_);
  const LeastSquares problem = posterior_.problem();
  const auto misfit = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    const Outcome here = problem.at(x);
    if (!here.residuals) return Eigen::VectorXd::Constant(volumes_, 1e3);
    return here.residuals->head(volumes_) + missed_at(x) - wanted;
  };
  Eigen::VectorXd x = problem.inside(draw), apart = misfit(x);
  Eigen::MatrixXd step = step_;
  double length = 1.0;
  for (int k = 0; k < steps && apart.norm() > enough; ++k) {
    Eigen::VectorXd next = x;
    next(moving_) += length * (step * apart);
    next = problem.inside(next);
    const Eigen::VectorXd there = misfit(next);
    const double part = there.norm() / apart.norm();
    const bool better = part<1.0, slow = part> 0.3;
    length = better ? 1.0 : 0.4 * length;
    if (better) {
      x = next;
      apart = there;
    }
    if (!slow) continue;
    if (const Slopes slopes = posterior_.slopes(x, moving_)) step = step_with(*slopes);
  }
  return x;
}

}  // namespace trunk
