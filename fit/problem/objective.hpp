#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "ledger/ledger.hpp"
#include "problem/measured_curve.hpp"
#include "problem/search_space.hpp"
#include "search/least_squares.hpp"

namespace trunk {

/// One simulation that a fit asked for, completed or failed.
struct Evaluation {
  Candidate candidate;
  double objective = 0.0;  // sum of squared deviations and priors; a penalty if the simulation failed
  Ending::Status status = Ending::Status::unset;
  double wall_s = 0.0;
};

/// How simulations are run.
struct Execution {
  unsigned threads = 0;  // 0: one per core
  std::function<bool()> cancelled;
  std::function<void(std::size_t)> progress;  // called with the number of simulations so far
};

/// The distance between a candidate's lung volume and the measured one (paper, "Estimation of the model
/// parameters", steps 2 and 3), as a least-squares problem in the coordinates of a search space. A simulation
/// that is in the ledger is not run again. The residuals are those of the curve in deviations, then the
/// priors.
class Objective {
 public:
  /// All arguments must outlive the objective. Throws InputError if the curve is empty or longer than the
  /// grid.
  Objective(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space, const MeasuredCurve& measured,
            Ledger& ledger, const Execution& execution = {});

  /// Returns the problem for a search. It throws Cancelled once the execution is cancelled. If a simulation
  /// fails, its objective is a finite penalty, smaller for a simulation that lasted longer: NLopt 2.7.1 takes
  /// NaN or infinity for success.
  LeastSquares problem();

  /// Returns the model at the measured samples, m3; none if the simulation fails.
  std::optional<Eigen::VectorXd> model(const Eigen::VectorXd& x);
  /// Returns the same for several points, simulated side by side.
  std::vector<std::optional<Eigen::VectorXd>> models(const std::vector<Eigen::VectorXd>& some);

  /// Applies this loss from now on; see robust_residuals.
  void use_loss(Loss loss, double scale);

  Eigen::Index samples() const noexcept { return measured_.size(); }
  const Eigen::VectorXd& measured() const noexcept { return measured_; }    // m3
  const Eigen::VectorXd& deviation() const noexcept { return deviation_; }  // m3
  const MeasuredCurve& measured_curve() const noexcept { return curve_; }
  const SearchSpace& space() const noexcept { return space_; }

  const std::vector<Evaluation>& evaluations() const noexcept { return evaluations_; }
  std::size_t simulated() const noexcept { return simulated_; }  // without those found in the ledger
  int failures() const noexcept;

 private:
  std::vector<const LedgerEntry*> entries(const std::vector<Candidate>& candidates);
  void simulate_missing(const std::vector<Candidate>& candidates, const std::vector<std::string>& keys);
  std::vector<LedgerEntry> simulate(const std::vector<Candidate>& candidates) const;
  LedgerEntry simulate_slopes(const Eigen::VectorXd& x, const Candidate& candidate) const;
  bool usable(const LedgerEntry* entry, std::size_t numbers) const;
  Slopes slopes(const Eigen::VectorXd& x);
  Outcome judged(const Eigen::VectorXd& x, const LedgerEntry& entry) const;
  std::vector<Outcome> outcomes(const std::vector<Eigen::VectorXd>& some);

  const Trunk& trunk_;
  const TimeGrid& grid_;
  const SearchSpace& space_;
  const MeasuredCurve& curve_;
  Ledger& ledger_;
  Execution execution_;
  Eigen::VectorXd measured_, deviation_;
  Loss loss_ = Loss::squares;
  double loss_scale_ = 1.0;
  std::vector<Evaluation> evaluations_;
  std::map<std::string, bool> asked_;
  std::size_t simulated_ = 0;
};

/// Returns the key of a simulation in the ledger: parameters and activation as bytes.
std::string ledger_key(const Candidate& candidate);

}  // namespace trunk
