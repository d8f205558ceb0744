#pragma once

#include <optional>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "problem/free_parameters.hpp"

namespace trunk {

/// One simulation asked for by a fit, kept for the record whether it worked or not.
struct Evaluation {
  Eigen::VectorXd x;       // coordinates of the search space
  double objective = 0.0;  // m6, sum of squares; a finite penalty where the simulation failed
  Summary::Status status = Summary::Status::unset;
  double wall_s = 0.0;
};

/// What the model should do: a volume curve at increasing times from 0, or its highest value alone, whenever
/// that comes (one entry of delta_v and no times).
struct Target {
  std::vector<double> time_s;   // [samples], or empty
  std::vector<double> delta_v;  // [samples] m3, or the tidal volume

  bool is_tidal_volume() const noexcept { return time_s.empty() && delta_v.size() == 1; }
};

/// The distance between a candidate's lung volume and the measured one (paper, "Estimation of the model
/// parameters", steps 2 and 3). Every evaluation is counted and kept.
class Objective {
 public:
  /// All must outlive the objective. Throws InputError where the target is empty or longer than the grid.
  Objective(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space, const Target& target);

  /// Model minus measured at the target's samples, m3; empty where the simulation failed.
  std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& x);

  /// The same for any candidate, in the search space or not; it is not recorded.
  std::optional<Eigen::VectorXd> residuals_of(const Candidate& candidate) const;

  /// Sum of squared residuals, m6. Where the simulation failed, a finite penalty above any useful value that
  /// falls the longer the simulation lasted: NLopt 2.7.1 takes NaN or infinity for success.
  double operator()(const Eigen::VectorXd& x);

  const std::vector<Evaluation>& evaluations() const noexcept { return evaluations_; }
  int failures() const noexcept;
  /// The evaluation with the lowest objective that did not fail; null where all failed.
  const Evaluation* best() const noexcept;
  const Target& target() const noexcept { return target_; }
  const SearchSpace& space() const noexcept { return space_; }

 private:
  struct Outcome {
    std::optional<Eigen::VectorXd> residuals;
    double objective;
  };
  std::optional<Eigen::VectorXd> residuals_of(const VolumeCurve& curve) const;
  Outcome evaluate(const Eigen::VectorXd& x);

  const Trunk& trunk_;
  const TimeGrid& grid_;
  const SearchSpace& space_;
  const Target& target_;
  double target_energy_ = 0.0;  // m6
  std::vector<Evaluation> evaluations_;
};

/// What a simulated curve shows of what the target names: its samples, or its highest value.
Eigen::VectorXd as_target_sees(const Target& target, const std::vector<double>& curve, double dt_s);

/// A curve sampled every dt_s from time 0, read off at the target's times, straight between its samples.
Eigen::VectorXd sampled(const std::vector<double>& curve, double dt_s, const std::vector<double>& time_s);

}  // namespace trunk
