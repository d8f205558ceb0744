#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "activation/breath_activation.hpp"
#include "model/parameters.hpp"

namespace trunk {

/// What a fit tries out: mechanical parameters and activation.
struct Candidate {
  Parameters<double> parameters;
  BreathActivation<double> activation;
};

/// A parameter that may be fitted, in its natural unit. All are positive and searched for by their logarithm,
/// within bounds wide enough for any adult (our choice).
struct FreeParameter {
  std::string_view name, unit, scenario_key;
  double lower, upper;
  double& (*field)(Candidate&);
};

std::span<const FreeParameter> free_parameters();

/// Throws InputError, listing the names there are.
const FreeParameter& free_parameter(const std::string& name);

/// Coordinates of a search: the logarithms of the free parameters, with k_muscle as log(k_muscle /
/// k_elasticity). In slow breathing the volume depends on that ratio alone, so the coordinates are nearly
/// independent of each other.
class SearchSpace {
 public:
  /// Throws InputError: no free parameter, one named twice, a start outside the bounds.
  SearchSpace(std::vector<std::string> names, const Candidate& start);

  std::size_t size() const noexcept { return free_.size(); }
  const FreeParameter& parameter(std::size_t i) const { return *free_[i]; }
  bool is_ratio(std::size_t i) const;

  Eigen::VectorXd encode(const Candidate& candidate) const;
  Candidate decode(const Eigen::VectorXd& x) const;
  Eigen::VectorXd start() const { return encode(start_); }
  Eigen::VectorXd lower() const;  // of the coordinates
  Eigen::VectorXd upper() const;

  /// d(log natural value) / d(coordinate): [size, size]. Turns a covariance of coordinates into one of logs.
  Eigen::MatrixXd log_values_by_coordinates() const;

 private:
  std::vector<const FreeParameter*> free_;
  Candidate start_;
};

}  // namespace trunk
