#pragma once

#include <Eigen/Core>
#include <optional>

#include "problem/free_parameters.hpp"

namespace trunk {

/// What is known of a parameter beforehand: a mean in its natural unit and a standard deviation of its
/// logarithm, or of the value where it is searched for by amounts. None: nothing is known.
struct Prior {
  std::string name;
  std::optional<double> mean;  // empty: the start
  double deviation = 0.0;      // 0: no prior
};

/// Where a search looks. Coordinates are the logarithms of the parameters, with k_muscle as log(k_muscle /
/// k_elasticity): in slow breathing the volume depends on that ratio alone, so the coordinates are nearly
/// independent of each other. What is searched for by amounts counts in tenths of its unit, so that all
/// coordinates are of one size.
///
/// Besides the parameters asked for, `beside` are estimated along with them: the timing taken from a trace is
/// itself uncertain, and what it was taken for would otherwise be charged to the others.
class SearchSpace {
 public:
  /// Throws InputError: no free parameter, one named twice or unknown, a start or prior outside the bounds.
  SearchSpace(const std::vector<std::string>& names, const Candidate& start,
              const std::vector<std::string>& beside = {}, const std::vector<Prior>& priors = {});

  std::size_t size() const noexcept { return parameters_.size(); }
  std::size_t asked_for() const noexcept { return asked_for_; }  // the first of them
  const FreeParameter& parameter(std::size_t i) const { return *parameters_[i]; }
  bool is_ratio(std::size_t i) const;
  std::optional<std::size_t> find(std::string_view name) const;

  /// Deviation of the prior that was given for it, of the logarithm or amount; 0: none was.
  double given_deviation(std::size_t i) const { return given_[i]; }

  Eigen::VectorXd encode(const Candidate& candidate) const;
  Candidate decode(const Eigen::VectorXd& x) const;
  Eigen::VectorXd start() const { return encode(start_); }
  Eigen::VectorXd lower() const;  // of the coordinates
  Eigen::VectorXd upper() const;

  /// d(logarithm, or amount, of the natural value) / d(coordinate): [size, size]. Turns a covariance of
  /// coordinates into one of the parameters.
  Eigen::MatrixXd values_by_coordinates() const;

  /// How decode(x) changes with each coordinate: [size].
  std::vector<Candidate> directions(const Eigen::VectorXd& x) const;

  /// What is known beforehand, as residuals of deviation 1: one a prior, one a bend of the activation's shape
  /// (second differences of the logarithms of neighbouring knots, deviation 0.3; our choice).
  Eigen::VectorXd prior_residuals(const Eigen::VectorXd& x) const;

 private:
  double coordinate(std::size_t i, double value, double elasticity) const;
  struct PriorRow {
    std::size_t i;
    double mean, deviation;  // of the coordinate
  };

  std::vector<const FreeParameter*> parameters_;
  std::size_t asked_for_ = 0;
  Candidate start_;
  std::vector<PriorRow> priors_;
  std::vector<double> given_;  // [size]
  bool shaped_ = false;
};

}  // namespace trunk
