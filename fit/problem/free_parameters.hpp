#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dynamics/trial.hpp"

namespace trunk {

/// What a fit tries out: mechanical parameters and activation.
using Candidate = Trial<double>;

/// A parameter that may be fitted, in its natural unit, within bounds wide enough for any adult (our choice).
struct FreeParameter {
  enum class Group { mechanics, timing, shape };
  /// How a search steps: by factors (all that is positive), or by amounts.
  enum class Scale { factor, amount };

  std::string_view name, unit, scenario_key;
  double lower, upper;
  Group group;
  double& (*field)(Candidate&);
  Scale scale = Scale::factor;
  /// Standard deviation about the start, of the natural logarithm or of the amount; 0: nothing is known
  /// beforehand.
  double prior = 0.0;
};

std::span<const FreeParameter> free_parameters();

/// Throws InputError, listing the names there are.
const FreeParameter& free_parameter(const std::string& name);

/// Names as a user gives them => names of parameters: `timing` stands for onset, rise and falls, `shape` for
/// all inner knots of the activation. Throws InputError on an unknown name.
std::vector<std::string> parameter_names(const std::vector<std::string>& given);

double value_of(const FreeParameter& parameter, const Candidate& candidate);

}  // namespace trunk
