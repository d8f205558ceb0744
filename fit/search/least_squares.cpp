#include "search/least_squares.hpp"

#include <algorithm>

namespace trunk {

LeastSquares with_fixed(const LeastSquares& problem, const Eigen::VectorXd& at,
                        const std::vector<Eigen::Index>& free) {
  const auto trials = [&problem, at, free](const std::vector<Eigen::VectorXd>& some) {
    std::vector<Eigen::VectorXd> all;
    for (const Eigen::VectorXd& x : some) {
      all.push_back(at);
      all.back()(free) = x;
    }
    return problem.trials(all);
  };
  return {trials, problem.lower(free), problem.upper(free)};
}

std::optional<Eigen::MatrixXd> jacobian(const LeastSquares& problem, const Eigen::VectorXd& x, double step) {
  std::vector<Eigen::VectorXd> points;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    for (const double side : {1.0, -1.0}) {
      points.push_back(x);
      points.back()[i] = std::clamp(x[i] + side * step, problem.lower[i], problem.upper[i]);
    }
  const std::vector<Trial> trials = problem.trials(points);
  Eigen::MatrixXd result;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto k = static_cast<std::size_t>(2 * i);
    const Trial &ahead = trials[k], &behind = trials[k + 1];
    if (!ahead.residuals || !behind.residuals) return std::nullopt;
    if (i == 0) result.resize(ahead.residuals->size(), x.size());
    const double width = points[k][i] - points[k + 1][i];
    result.col(i) = (*ahead.residuals - *behind.residuals) / width;
  }
  return result;
}

}  // namespace trunk
