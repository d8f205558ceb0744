#pragma once

#include "problem/search_space.hpp"

namespace trunk {

/// What is known beforehand of the forces in a trunk, for a fit in which they count: a mean, a factor of one
/// standard deviation, and where it comes from.
struct ScalePrior {
  std::string name, unit;
  double mean = 0.0, factor = 1.0;
  std::string source;
};

/// The source of a prior that the user gave.
inline constexpr std::string_view given_source = "given";

/// The name of the prior on the abdominal elastance, which is no parameter: k_elasticity and the factor of
/// the wall make it. Along the one direction that no pressure sees, it stays.
inline constexpr std::string_view abdominal_elastance_prior = "abdominal_elastance";

/// Returns the priors of a trunk with these parameters: that of the abdominal elastance first, then those of
/// the parameters that move along. `lung`: the trunk has one.
std::vector<ScalePrior> scale_priors(const Parameters<double>& parameters, bool lung);

}  // namespace trunk
