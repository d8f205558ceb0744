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

/// A sum of squares to be made small, within bounds, in coordinates of order one. `outcomes` is given several
/// points at once so that they can be worked off side by side; what it throws passes through every search.
struct LeastSquares {
  std::function<std::vector<Outcome>(const std::vector<Eigen::VectorXd>&)> outcomes;
  Eigen::VectorXd lower, upper;

  Eigen::Index size() const noexcept { return lower.size(); }
  Outcome at(const Eigen::VectorXd& x) const { return outcomes({x}).front(); }
  Eigen::VectorXd inside(const Eigen::VectorXd& x) const { return x.cwiseMax(lower).cwiseMin(upper); }
};

/// The same problem with some coordinates held at those of `at`.
LeastSquares with_fixed(const LeastSquares& problem, const Eigen::VectorXd& at,
                        const std::vector<Eigen::Index>& free);

/// Central differences of the residuals, [residuals, coordinates], one-sided at a bound; `step` in
/// coordinates. None where a neighbour of x cannot be computed.
std::optional<Eigen::MatrixXd> jacobian(const LeastSquares& problem, const Eigen::VectorXd& x,
                                        double step = 1e-3);

/// Forward differences, backward at an upper bound: half the cost, for the steps of a search. The step of
/// 1e-5 leaves an error of 1e-5 of the curvature and is far above the round-off of a simulation.
std::optional<Eigen::MatrixXd> forward_jacobian(const LeastSquares& problem, const Eigen::VectorXd& x);

/// A search was told to stop; thrown through it by a problem whose user gave up.
struct Cancelled {};

}  // namespace trunk
