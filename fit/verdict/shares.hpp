#pragma once

#include <string>
#include <vector>

#include "estimation/fit_problem.hpp"
#include "uncertainty/uncertainty.hpp"

namespace trunk {

/// What a result rests on: a source of information, and its part of all that is known of the result.
struct Share {
  std::string source;  // "volume", "gastric pressure", "prior of lung_elastance", "timing", "shape" ...
  double part = 0.0;
  bool measured = false;  // otherwise it is a prior
  double pull = 0.0;      // of a prior: how many of its deviations the best point is from its mean
};

/// Returns what a number rests on, the largest share first. `gradient` is its derivative by the coordinates.
/// With J the rows of all residuals and C = (J'J)^-1, a source s gives |J_s C g|^2 of g'C g: the shares add
/// up to 1, and each is the part of the information, and of the variance, that comes from the source.
std::vector<Share> shares_of(const FitProblem& problem, const LocalFit& fit, const Eigen::VectorXd& gradient);

/// Returns the part of the shares that priors have.
double prior_part(const std::vector<Share>& shares);

/// Returns "gastric pressure 71 %, volume 20 %, prior of resistance 9 %": the shares of 1 % and more.
std::string text_of(const std::vector<Share>& shares);

}  // namespace trunk
