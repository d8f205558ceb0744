#include "subject/fixed_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "results/read/read_records.hpp"
#include "results/read/stored_run.hpp"

namespace trunk {
namespace {

/// The value of a parameter in a result file. An error of the file names the option as well.
double stored_value(const std::filesystem::path& source, const std::string& name, const Place& option) {
  std::vector<NamedValue> parameters;
  std::vector<FitRecord::Gate> gates;
  try {
    parameters = read_parameters(source);
    gates = read_gates(source);
  } catch (const InputError& error) {
    rethrow_named_in(option, error);
  }
  if (!gates.empty())
    throw InputError(option,
                     fmt::format("{} withholds {}: {}", source.string(), name, gates.front().sentence),
                     "a fit that no gate stops", "give the value as a number");
  for (const NamedValue& v : parameters)
    if (v.name == name) return v.value;
  throw InputError(option, fmt::format("{} holds no value of {}", source.string(), name),
                   "the result of a fit or of a simulation");
}

double number_in(const std::string& text, const Place& option, const std::string& expected) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(option, "'" + text + "' is not a number", expected);
  return value;
}

}  // namespace

FixedParameter fixed_parameter(const std::string& text) {
  const std::string expected = "name=value or name=@file.h5, as in --fix k_elasticity=4000";
  const Place option{"--fix " + text};
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw InputError(option, "no value is given", expected);
  const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
  FixedParameter fixed{&free_parameter(name, option), 0.0, {}};
  if (value.starts_with('@')) {
    fixed.source = value.substr(1);
    fixed.value = stored_value(*fixed.source, name, option);
  } else {
    fixed.value = number_in(value, option, expected);
  }
  const FreeParameter& p = *fixed.parameter;
  if (!(fixed.value >= p.lower && fixed.value <= p.upper))
    throw InputError(option, fmt::format("{:g} {} is out of bounds", fixed.value, p.unit),
                     fmt::format("{:g} to {:g} {}", p.lower, p.upper, p.unit));
  return fixed;
}

std::vector<std::string> names_to_fit(const std::vector<std::string>& free,
                                      const std::vector<FixedParameter>& fixed, bool one_number,
                                      Mistakes& mistakes) {
  std::vector<std::string> names;
  for (const std::string& text : free)
    mistakes.gather([&] {
      for (std::string& name : parameter_names({text})) names.push_back(std::move(name));
    });
  if (free.empty())
    names = one_number ? std::vector<std::string>{"k_muscle"}
                       : std::vector<std::string>{"k_elasticity", "k_muscle"};
  for (const FixedParameter& held : fixed) {
    if (!free.empty() && std::count(names.begin(), names.end(), held.name()) > 0)
      mistakes.add({{}, "parameter '" + held.name() + "' is both free and fixed", "one of the two", "", {}});
    std::erase(names, held.name());
  }
  for (const std::string& name : names)
    if (std::count(names.begin(), names.end(), name) > 1)
      mistakes.add({{}, "parameter '" + name + "' is named twice", "every name once", "", {}});
  if (names.empty() && free.empty())
    mistakes.add({{}, "no parameter is free", "at least one: --free k_elasticity,k_muscle", "", {}});
  return names;
}

}  // namespace trunk
