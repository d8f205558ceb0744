#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace trunk {

/// What one set of coordinates came to.
struct Outcome {
  std::optional<Eigen::VectorXd> residuals;  // none where the model failed
  double objective = 0.0;  // their sum of squares; where the model failed, finite and above any useful value
};

/// The derivatives of the residuals, [residuals, coordinates]; none where the model fails.
using Slopes = std::optional<Eigen::MatrixXd>;

/// A sum of squares to be made small, within bounds, in coordinates of order one. `outcomes` is given several
/// points at once so that they can be worked off side by side; what it throws passes through every search.
struct LeastSquares {
  std::function<std::vector<Outcome>(const std::vector<Eigen::VectorXd>&)> outcomes;
  Eigen::VectorXd lower, upper;
  std::function<Slopes(const Eigen::VectorXd&)> exact_slopes = {};  // empty: only differences are to be had

  Eigen::Index size() const noexcept { return lower.size(); }
  Outcome at(const Eigen::VectorXd& x) const { return outcomes({x}).front(); }
  Eigen::VectorXd inside(const Eigen::VectorXd& x) const { return x.cwiseMax(lower).cwiseMin(upper); }
};

/// The same problem with some coordinates held at those of `at`.
LeastSquares with_fixed(const LeastSquares& problem, const Eigen::VectorXd& at,
                        const std::vector<Eigen::Index>& free);

/// Central differences over `step` in coordinates, one-sided at a bound. A chord of that length is what a
/// confidence interval wants of a curved model.
Slopes jacobian(const LeastSquares& problem, const Eigen::VectorXd& x, double step = 1e-3);

/// For the steps of a search: the problem's own, or forward differences, backward at an upper bound, of 1e-6.
Slopes slopes_at(const LeastSquares& problem, const Eigen::VectorXd& x);

/// A search was told to stop; thrown through it by a problem whose user gave up.
struct Cancelled {};

}  // namespace trunk
