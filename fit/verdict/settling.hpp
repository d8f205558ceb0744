#pragma once

#include "estimation/estimate.hpp"
#include "estimation/nuisance.hpp"

namespace trunk {

/// Brings draws of a fit's linear model back to the volume. Where priors alone know the scale of forces, a
/// draw may have twice the stiffness of the best point, and straight lines in the coordinates then miss the
/// volume that was measured.
///
/// k_muscle, the timing and the shape of the activation move until the compartment has the volume that the
/// linear model gives the draw; they move as little as their priors allow. The other mechanical parameters
/// stay. Steps are those of Gauss and Newton, with the slopes of the best point as long as these serve. A
/// draw that no such step brings back stays as near as it came. What the compartment misses of the trunk's
/// volume that far away is measured by two simulations along each axis of the covariance of the parameters
/// that stay, and taken as a parabola along the axis (our choice).
class Settling {
 public:
  /// `problem` and what it refers to must outlive this. The estimation must have a local fit.
  Settling(const FitProblem& problem, const Estimation& estimation);

  /// Returns the coordinates of a draw, settled.
  Eigen::VectorXd operator()(const Eigen::VectorXd& draw);

 private:
  /// What the compartment misses along one axis: odd z + even z^2, [volumes], with z from the best point.
  struct Axis {
    Eigen::VectorXd along;  // [coordinates], z = along . (x - best)
    Eigen::VectorXd odd, even;
  };

  Eigen::VectorXd missed_at(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd step_with(const Eigen::MatrixXd& slopes) const;
  void measure_axes(const FitProblem& problem);

  const LocalFit& fit_;
  Eigen::Index volumes_;  // the residuals of the volume come first
  CompartmentModel model_;
  Objective posterior_;
  Indices moving_{};
  Eigen::MatrixXd step_;  // of the moving coordinates, with the slopes of the best point, [moving, volumes]
  std::vector<Axis> axes_{};
};

}  // namespace trunk
