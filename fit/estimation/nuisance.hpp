#pragma once

#include "problem/objective.hpp"

namespace trunk {

using Indices = std::vector<Eigen::Index>;

/// The trunk's log-posterior as a function of a few coordinates alone; the others (the nuisance) take their
/// best values at each point. Those come from the compartment in two steps: a search of the compartment, then
/// one Gauss-Newton step on the residuals of the trunk, with the slopes of the compartment. So each point
/// costs one simulation.
class WithoutNuisance {
 public:
  /// Both objectives, which share their space, must outlive this. The compartment is to be exact near `at`.
  WithoutNuisance(Objective& trunk, Objective& compartment, const Eigen::VectorXd& at, const Indices& kept);

  /// Returns the problem in the coordinates kept. Its residuals are what no nuisance can explain. Its slopes
  /// are differences, for which the points are simulated side by side.
  LeastSquares problem();

  /// Returns all coordinates, with the best nuisance for the coordinates kept. One simulation.
  Eigen::VectorXd completed(const Eigen::VectorXd& kept);

 private:
  Eigen::VectorXd by_compartment(const Eigen::VectorXd& kept);
  Eigen::MatrixXd without_nuisance(const Eigen::MatrixXd& rows, const Eigen::VectorXd& all);
  Outcome eliminated(const Eigen::VectorXd& all, const Outcome& outcome);

  Objective &trunk_, &compartment_;
  Eigen::VectorXd at_;
  Indices kept_, nuisance_;
};

/// Returns the compartment's best coordinates if `kept` ones stay as they are in `at`.
Eigen::VectorXd best_nuisance(const LeastSquares& compartment, const Eigen::VectorXd& at,
                              const Indices& kept);

/// Returns the coordinates that are not in `some`, of `count`.
Indices all_but(const Indices& some, std::size_t count);

}  // namespace trunk
