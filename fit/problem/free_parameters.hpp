#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dynamics/trial.hpp"
#include "errors/input_error.hpp"

namespace trunk {

/// One set of values that a fit tries: mechanical parameters and activation.
using Candidate = Trial<double>;

/// A parameter that can be fitted, in its natural unit. The bounds are wide enough for any adult (our
/// choice).
struct FreeParameter {
  enum class Group { mechanics, timing, shape };
  /// A search changes positive parameters by factors, and others by amounts.
  enum class Scale { factor, amount };

  std::string_view name, unit, scenario_key;
  double lower, upper;
  Group group;
  double& (*field)(Candidate&);
  Scale scale = Scale::factor;
  /// Standard deviation of the prior about the start, of the natural logarithm or of the amount; 0: no prior.
  double prior = 0.0;
  double to_si = 1.0;    // the field, in SI units, over the natural unit
  bool of_lung = false;  // it is 0, and counts for nothing, in a trunk without a lung
};

/// Returns all parameters that can be fitted, in the order of results tables.
std::span<const FreeParameter> free_parameters();

/// Returns the parameter of that name; throws InputError with the known names if there is none. `at` is where
/// the name stands.
const FreeParameter& free_parameter(const std::string& name, const Place& at = {});

/// Returns names of parameters for the names given to --free: `timing` stands for onset, rise and both falls,
/// `shape` for all inner knots of the activation. Throws InputError if a name is unknown.
std::vector<std::string> parameter_names(const std::vector<std::string>& given);

/// Returns the value of the parameter in the candidate, in its natural unit.
double value_of(const FreeParameter& parameter, const Candidate& candidate);

/// Sets the parameter to a value in its natural unit. => candidate
void set_value(const FreeParameter& parameter, double value, Candidate& candidate);

}  // namespace trunk
