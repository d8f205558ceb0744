#pragma once

#include <Eigen/Core>
#include <optional>

#include "problem/free_parameters.hpp"

namespace trunk {

/// What is known about a parameter before the fit: a mean in its natural unit, and a standard deviation of
/// the logarithm (of the value, if the search changes the parameter by amounts).
struct Prior {
  std::string name;
  std::optional<double> mean;  // empty: the start
  double deviation = 0.0;      // 0: no prior
};

/// The coordinates of a search. They are the logarithms of the parameters, except that k_muscle becomes
/// log(k_muscle / k_elasticity): in slow breathing the volume depends only on that ratio, so the coordinates
/// are nearly independent. A parameter that is changed by amounts counts in tenths of its unit, so that all
/// coordinates have about the same size.
///
/// The parameters `beside` (nuisance parameters) are estimated together with those asked for. For example,
/// the timing read from a trace is uncertain, and its errors would otherwise bias the other parameters.
class SearchSpace {
 public:
  /// Throws InputError if no parameter is free, if a name is unknown or given twice, if a start or prior is
  /// outside its bounds, or if a prior belongs to a parameter that is not fitted.
  SearchSpace(const std::vector<std::string>& names, const Candidate& start,
              const std::vector<std::string>& beside = {}, const std::vector<Prior>& priors = {});

  std::size_t size() const noexcept { return parameters_.size(); }
  std::size_t asked_for() const noexcept { return asked_for_; }  // they come first, then those beside
  const FreeParameter& parameter(std::size_t i) const { return *parameters_[i]; }
  bool is_ratio(std::size_t i) const;
  std::optional<std::size_t> find(std::string_view name) const;

  /// Returns the deviation of the prior given for a parameter, of the logarithm or amount; 0: none was given.
  double given_deviation(std::size_t i) const { return given_[i]; }

  Eigen::VectorXd encode(const Candidate& candidate) const;
  Candidate decode(const Eigen::VectorXd& x) const;
  Eigen::VectorXd start() const { return encode(start_); }
  Eigen::VectorXd lower() const;  // of the coordinates
  Eigen::VectorXd upper() const;

  /// Returns d(logarithm, or amount, of the natural value) / d(coordinate), [size, size]. It turns a
  /// covariance of the coordinates into one of the parameters.
  Eigen::MatrixXd values_by_coordinates() const;

  /// Returns the derivative of decode(x) with respect to each coordinate, [size].
  std::vector<Candidate> directions(const Eigen::VectorXd& x) const;

  /// Returns the priors as residuals of deviation 1: one for each prior, and one for each bend of the
  /// activation's shape (second difference of the logarithms of neighbouring knots, which is that of the
  /// start with a deviation of 0.3; our choice).
  Eigen::VectorXd prior_residuals(const Eigen::VectorXd& x) const;

  /// Returns the names of these residuals: that of the parameter, or "shape" for a bend.
  std::vector<std::string> prior_names() const;

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
