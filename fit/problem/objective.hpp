#pragma once

#include <map>
#include <optional>
#include <vector>

#include "dynamics/simulate.hpp"
#include "problem/measured_curve.hpp"
#include "problem/search_space.hpp"
#include "problem/volume_model.hpp"
#include "search/least_squares.hpp"

namespace trunk {

/// One simulation that a fit asked for, completed or failed.
struct Evaluation {
  Candidate candidate;
  double objective = 0.0;  // sum of squared deviations and priors; a penalty if the simulation failed
  Ending::Status status = Ending::Status::unset;
  double wall_s = 0.0;
};

/// What is known of a candidate beside its volume curve: a residual of deviation 1.
using Knowledge = std::function<double(const Candidate&)>;

/// The log-posterior of a fit, as a least-squares problem in the coordinates of a search space: -2 log of it
/// is the sum of squares, up to a constant. Its residuals are the distance between the model's lung volume
/// and the measured one, in deviations (paper, "Estimation of the model parameters", steps 2 and 3), then the
/// priors of the space, then what else is known. The search, the intervals, the profiles, the joint region
/// and the predictions all use it.
class Objective {
 public:
  /// All arguments must outlive the objective. Throws InputError if the curve is empty or longer than the
  /// grid.
  Objective(VolumeModel& model, const TimeGrid& grid, const SearchSpace& space, const MeasuredCurve& measured,
            Knowledge knowledge = {});

  /// Returns the problem for a search. If a simulation fails, its objective is a finite penalty, smaller for
  /// a simulation that lasted longer: NLopt 2.7.1 takes NaN or infinity for success.
  LeastSquares problem();

  /// Returns the derivatives of the residuals by some coordinates, [residuals, some]: the exact ones if the
  /// model has them, otherwise central differences. None if a simulation fails.
  Slopes slopes(const Eigen::VectorXd& x, const std::vector<Eigen::Index>& some);

  /// Returns the model at the measured samples, m3; none if the simulation fails.
  std::optional<Eigen::VectorXd> model(const Eigen::VectorXd& x);

  /// Takes neighbouring samples as correlated from now on, AR(1) with this coefficient: the residuals of the
  /// curve become (r_i - rho r_(i-1)) / sqrt(1 - rho^2), which are independent.
  void use_correlation(double rho) noexcept { rho_ = rho; }

  /// Returns columns of values at the samples, m3, as residuals are: in deviations and independent. [samples,
  /// n]
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& volumes_m3) const;

  /// Applies this loss from now on; see robust_residuals.
  void use_loss(Loss loss, double scale);

  Eigen::Index samples() const noexcept { return measured_.size(); }
  const Eigen::VectorXd& measured() const noexcept { return measured_; }    // m3
  const Eigen::VectorXd& deviation() const noexcept { return deviation_; }  // m3
  const MeasuredCurve& measured_curve() const noexcept { return curve_; }
  const SearchSpace& space() const noexcept { return space_; }

  const std::vector<Evaluation>& evaluations() const noexcept { return evaluations_; }
  int failures() const noexcept;

 private:
  Eigen::VectorXd known(const Eigen::VectorXd& x) const;
  Slopes slopes(const Eigen::VectorXd& x);
  Outcome judged(const Eigen::VectorXd& x, const LedgerEntry& entry) const;
  std::vector<Outcome> outcomes(const std::vector<Eigen::VectorXd>& some);

  VolumeModel& volumes_;
  const TimeGrid& grid_;
  const SearchSpace& space_;
  const MeasuredCurve& curve_;
  Knowledge knowledge_;
  Eigen::VectorXd measured_, deviation_;
  Loss loss_ = Loss::squares;
  double loss_scale_ = 1.0, rho_ = 0.0;
  std::vector<Evaluation> evaluations_;
  std::map<std::string, bool> asked_;
};

}  // namespace trunk
