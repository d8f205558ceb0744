#include "uncertainty/refit.hpp"

#include <limits>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

struct Walker {
  Eigen::VectorXd x;
  Refit best;
};

void judge(const LeastSquares& problem, const std::vector<Eigen::VectorXd>& shift, std::vector<Walker>& all,
           std::vector<std::optional<Eigen::VectorXd>>& residuals) {
  std::vector<Eigen::VectorXd> points;
  for (const Walker& w : all) points.push_back(w.x);
  const std::vector<Outcome> outcomes = problem.outcomes(points);
  for (std::size_t i = 0; i < all.size(); ++i) {
    residuals[i] = outcomes[i].residuals;
    double objective = outcomes[i].objective;
    if (residuals[i] && !shift.empty()) {
      residuals[i]->head(shift[i].size()) -= shift[i];
      objective = residuals[i]->squaredNorm();
    }
    if (objective < all[i].best.objective)
      all[i].best = {all[i].x, objective, all[i].best.at_bound};
    else if (!residuals[i])
      all[i].x = all[i].best.x;
  }
}

}  // namespace

std::vector<Refit> refits(const LeastSquares& problem, const LocalFit& fit, const Eigen::MatrixXd& directions,
                          const std::vector<Eigen::VectorXd>& starts,
                          const std::vector<Eigen::VectorXd>& shift, int steps) {
  Eigen::MatrixXd step_of;
  if (directions.cols() > 0) {  // Eigen 3.4 crashes on a matrix without columns
    const Eigen::MatrixXd rows = fit.rows * directions;
    step_of = -directions * pseudo_inverse(rows);
  }
  std::vector<Walker> all;
  for (const Eigen::VectorXd& start : starts) {
    const Eigen::VectorXd x = problem.inside(start);
    all.push_back({x, {x, std::numeric_limits<double>::infinity(), x != start}});
  }
  std::vector<std::optional<Eigen::VectorXd>> residuals(all.size());
  judge(problem, shift, all, residuals);
  for (int k = 0; k < steps && directions.cols() > 0; ++k) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!residuals[i]) continue;
      const Eigen::VectorXd wanted = all[i].x + step_of * *residuals[i];
      all[i].x = problem.inside(wanted);
      all[i].best.at_bound = (all[i].x - wanted).cwiseAbs().maxCoeff() > 1e-9;
    }
    judge(problem, shift, all, residuals);
  }
  std::vector<Refit> result;
  for (Walker& w : all) result.push_back(std::move(w.best));
  return result;
}

}  // namespace trunk
