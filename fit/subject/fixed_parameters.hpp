#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "errors/input_error.hpp"
#include "problem/free_parameters.hpp"

namespace trunk {

/// A parameter that a fit holds at a value: --fix name=value or --fix name=@file.h5.
struct FixedParameter {
  const FreeParameter* parameter = nullptr;
  double value = 0.0;                           // in the natural unit, within the bounds of the parameter
  std::optional<std::filesystem::path> source;  // the result file that gave the value

  std::string name() const { return std::string(parameter->name); }
};

/// Reads one --fix, and the file that it names. Throws InputError if the text has another form, if there is
/// no such parameter, if the file holds no value of it, or if the value is out of bounds.
FixedParameter fixed_parameter(const std::string& text);

/// Returns the names of the parameters to fit: those that `free` gives, or k_elasticity and k_muscle
/// (k_muscle alone if one number was measured), less those in `fixed`. Adds to `mistakes` each name that is
/// unknown, that stands twice, or that is both free and fixed, and says so if no name is left.
std::vector<std::string> names_to_fit(const std::vector<std::string>& free,
                                      const std::vector<FixedParameter>& fixed, bool one_number,
                                      Mistakes& mistakes);

}  // namespace trunk
