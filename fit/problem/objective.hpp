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

/// One simulation asked for by a fit, kept for the record whether it worked or not.
struct Evaluation {
  Candidate candidate;
  double objective = 0.0;  // deviations squared, with what is known beforehand; a penalty where it failed
  Ending::Status status = Ending::Status::unset;
  double wall_s = 0.0;
};

/// How simulations are carried out.
struct Execution {
  unsigned threads = 0;  // 0: one a core
  std::function<bool()> cancelled;
  std::function<void(std::size_t)> progress;  // told the number of simulations
};

/// The distance between a candidate's lung volume and the measured one (paper, "Estimation of the model
/// parameters", steps 2 and 3), as a least-squares problem in the coordinates of a search space. What was
/// simulated before is looked up in the ledger. Residuals: those of the curve in deviations, then what is
/// known beforehand.
class Objective {
 public:
  /// All must outlive the objective. Throws InputError where the measured is empty or longer than the grid.
  Objective(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space, const MeasuredCurve& measured,
            Ledger& ledger, const Execution& execution = {});

  /// Throws Cancelled where the execution is told to stop. Where the simulation failed, the objective is a
  /// finite penalty that falls the longer the simulation lasted: NLopt 2.7.1 takes NaN or infinity for
  /// success.
  LeastSquares problem();

  /// The model at the measured samples, m3; none where the simulation failed.
  std::optional<Eigen::VectorXd> model(const Eigen::VectorXd& x);
  /// The same for several, side by side.
  std::vector<std::optional<Eigen::VectorXd>> models(const std::vector<Eigen::VectorXd>& some);

  void use_loss(Loss loss, double scale);

  Eigen::Index samples() const noexcept { return measured_.size(); }
  const Eigen::VectorXd& measured() const noexcept { return measured_; }    // m3
  const Eigen::VectorXd& deviation() const noexcept { return deviation_; }  // m3
  const MeasuredCurve& measured_curve() const noexcept { return curve_; }
  const SearchSpace& space() const noexcept { return space_; }

  const std::vector<Evaluation>& evaluations() const noexcept { return evaluations_; }
  std::size_t simulated() const noexcept { return simulated_; }  // not counting what the ledger knew
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

/// The parameters and the activation as bytes: what the ledger knows a simulation by.
std::string ledger_key(const Candidate& candidate);

}  // namespace trunk
