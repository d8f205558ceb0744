#include "search/least_squares.hpp"

#include <algorithm>

namespace trunk {

LeastSquares with_fixed(const LeastSquares& problem, const Eigen::VectorXd& at,
                        const std::vector<Eigen::Index>& free) {
  const auto completed = [at, free](const Eigen::VectorXd& x) {
    Eigen::VectorXd all = at;
    all(free) = x;
    return all;
  };
  LeastSquares part{{}, problem.lower(free), problem.upper(free)};
  part.outcomes = [&problem, completed](const std::vector<Eigen::VectorXd>& some) {
    std::vector<Eigen::VectorXd> all;
    for (const Eigen::VectorXd& x : some) all.push_back(completed(x));
    return problem.outcomes(all);
  };
  if (problem.exact_slopes)
    part.exact_slopes = [&problem, completed, free](const Eigen::VectorXd& x) -> Slopes {
      const Slopes all = problem.exact_slopes(completed(x));
      if (!all) return std::nullopt;
      return Eigen::MatrixXd((*all)(Eigen::all, free));
    };
  return part;
}

namespace {

/// Returns difference quotients; the k-th pair of points differs in coordinate k.
Slopes differences(const std::vector<Eigen::VectorXd>& ahead, const std::vector<Outcome>& outcomes_ahead,
                   const std::vector<Eigen::VectorXd>& behind, const std::vector<Outcome>& outcomes_behind) {
  Eigen::MatrixXd result;
  for (std::size_t k = 0; k < ahead.size(); ++k) {
    const auto &a = outcomes_ahead[k].residuals, &b = outcomes_behind[k].residuals;
    if (!a || !b) return std::nullopt;
    const auto i = static_cast<Eigen::Index>(k);
    if (k == 0) result.resize(a->size(), static_cast<Eigen::Index>(ahead.size()));
    result.col(i) = (*a - *b) / (ahead[k][i] - behind[k][i]);
  }
  return result;
}

/// Returns x moved by `step` in each coordinate in turn, within the bounds.
std::vector<Eigen::VectorXd> moved(const LeastSquares& problem, const Eigen::VectorXd& x, double step) {
  std::vector<Eigen::VectorXd> points;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    points.push_back(x);
    points.back()[i] = std::clamp(x[i] + step, problem.lower[i], problem.upper[i]);
  }
  return points;
}

}  // namespace

Slopes jacobian(const LeastSquares& problem, const Eigen::VectorXd& x, double step) {
  const std::vector<Eigen::VectorXd> ahead = moved(problem, x, step), behind = moved(problem, x, -step);
  std::vector<Eigen::VectorXd> all = ahead;
  all.insert(all.end(), behind.begin(), behind.end());
  const std::vector<Outcome> outcomes = problem.outcomes(all);
  const auto middle = outcomes.begin() + static_cast<std::ptrdiff_t>(ahead.size());
  return differences(ahead, {outcomes.begin(), middle}, behind, {middle, outcomes.end()});
}

Slopes slopes_at(const LeastSquares& problem, const Eigen::VectorXd& x) {
  if (problem.exact_slopes) return problem.exact_slopes(x);
  const double step = 1e-6;
  std::vector<Eigen::VectorXd> ahead = moved(problem, x, step);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (x[i] + step > problem.upper[i]) ahead[static_cast<std::size_t>(i)][i] = x[i] - step;
  std::vector<Eigen::VectorXd> all = ahead;
  all.push_back(x);
  const std::vector<Outcome> outcomes = problem.outcomes(all);
  const std::vector<Eigen::VectorXd> behind(ahead.size(), x);
  return differences(ahead, {outcomes.begin(), outcomes.end() - 1}, behind,
                     std::vector<Outcome>(ahead.size(), outcomes.back()));
}

}  // namespace trunk
