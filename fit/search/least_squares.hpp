#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace trunk {

/// The result of the model at one point.
struct Outcome {
  std::optional<Eigen::VectorXd> residuals;  // none if the model failed
  double objective = 0.0;  // their sum of squares; if the model failed, finite and above any useful value
};

/// The derivatives of the residuals, [residuals, coordinates]; none if the model failed.
using Slopes = std::optional<Eigen::MatrixXd>;

/// A sum of squares to minimise within bounds, in coordinates of order one. `outcomes` gets several points at
/// once, so that it can compute them side by side. An exception that it throws passes through every search.
struct LeastSquares {
  std::function<std::vector<Outcome>(const std::vector<Eigen::VectorXd>&)> outcomes;
  Eigen::VectorXd lower, upper;
  std::function<Slopes(const Eigen::VectorXd&)> exact_slopes = {};  // empty: use differences

  Eigen::Index size() const noexcept { return lower.size(); }
  Outcome at(const Eigen::VectorXd& x) const { return outcomes({x}).front(); }
  Eigen::VectorXd inside(const Eigen::VectorXd& x) const { return x.cwiseMax(lower).cwiseMin(upper); }
};

/// Returns the problem in the `free` coordinates alone; the others keep their values in `at`. The original
/// problem must outlive it.
LeastSquares with_fixed(const LeastSquares& problem, const Eigen::VectorXd& at,
                        const std::vector<Eigen::Index>& free);

/// Returns central differences over `step` in coordinates, one-sided at a bound. The step is long on purpose:
/// a confidence interval of a curved model needs the slope over such a distance (our choice).
Slopes jacobian(const LeastSquares& problem, const Eigen::VectorXd& x, double step = 1e-3);

/// Returns the slopes for the steps of a search: the exact ones if the problem has them, otherwise forward
/// differences over 1e-6, backward at an upper bound.
Slopes slopes_at(const LeastSquares& problem, const Eigen::VectorXd& x);

/// A problem throws this through a search once its user cancels the fit.
struct Cancelled {};

}  // namespace trunk
