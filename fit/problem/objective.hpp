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

/// What is known of a candidate beside what was measured: residuals of deviation 1, and what each rests on.
struct KnownFact {
  std::string name;
  std::function<double(const Candidate&)> residual;
};
using Knowledge = std::vector<KnownFact>;

/// The log-posterior of a fit, as a least-squares problem in the coordinates of a search space: -2 log of it
/// is the sum of squares, up to a constant. Its residuals are the distance between what the model says and
/// what was measured, in deviations (for the volume: paper, "Estimation of the model parameters", steps 2 and
/// 3), then the priors of the space, then what else is known. What an observable may have beside the model
/// (see nuisance_of) is taken out of its residuals: it has the values that fit best, everywhere. The search,
/// the intervals, the profiles, the joint region and the predictions all use it.
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

  /// Returns the model's values, one block after the other; none if the simulation fails.
  std::optional<Eigen::VectorXd> model(const Eigen::VectorXd& x);

  /// Gives each block but the volume a deviation, [blocks - 1], from now on.
  void reweigh(const std::vector<double>& deviations);

  /// Takes neighbouring samples of the volume as correlated from now on, AR(1) with this coefficient: the
  /// residuals of the curve become (r_i - rho r_(i-1)) / sqrt(1 - rho^2), which are independent.
  void use_correlation(double rho) noexcept { rho_ = rho; }

  /// Returns columns of values as residuals are: in deviations, independent, and without what an observable
  /// may have beside the model. [values, n]
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& values) const;

  /// Applies this loss from now on; see robust_residuals.
  void use_loss(Loss loss, double scale);

  /// Returns the names of the residuals that do not come from what was measured, in their order.
  std::vector<std::string> known_names() const;

  Eigen::Index samples() const noexcept { return measured_.size(); }        // of all blocks
  const std::vector<Block>& blocks() const noexcept { return blocks_; }     // the volume comes first
  const Eigen::VectorXd& measured() const noexcept { return measured_; }    // [values] m3, then as channels
  const Eigen::VectorXd& deviation() const noexcept { return deviation_; }  // [values]
  /// Returns what a block may have beside the model, as orthonormal columns of residuals, [values, n].
  const Eigen::MatrixXd& nuisance(std::size_t block) const { return nuisance_[block]; }
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
  std::vector<Block> blocks_;
  Eigen::VectorXd measured_, deviation_;
  std::vector<Eigen::MatrixXd> nuisance_;  // [blocks]
  Loss loss_ = Loss::squares;
  double loss_scale_ = 1.0, rho_ = 0.0;
  std::vector<Evaluation> evaluations_;
  std::map<std::string, bool> asked_;
};

}  // namespace trunk
