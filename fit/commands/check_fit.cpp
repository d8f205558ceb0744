#include "commands/check_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "commands/fit_job.hpp"

namespace trunk {
namespace {

/// --fix name=value or name=@file.h5, as fit takes it. Returns the name.
std::string check_fixed(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError("--fix " + text +
                     ": expected name=value or name=@file.h5, as in --fix k_elasticity=4000");
  const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
  const FreeParameter& p = free_parameter(name);
  if (value.starts_with('@')) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(value.substr(1), ignored))
      throw InputError("--fix " + text + ": no such file, expected the result of a fit");
    return name;
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size() || !(number >= p.lower && number <= p.upper))
    throw InputError(fmt::format("--fix {}: expected {:g} to {:g} {}", text, p.lower, p.upper, p.unit));
  return name;
}

/// Whether fitting this parameter from this scenario makes sense. Timing starts from the trace.
void check_free(const std::string& name, const ScenarioFile& file) {
  const FreeParameter& p = free_parameter(name);
  Candidate start{file.scenario.parameters, file.scenario.activation};
  const std::string key(p.scenario_key);
  const bool starts_here = p.group == FreeParameter::Group::mechanics;
  if (const double value = p.field(start); starts_here && !(value >= p.lower && value <= p.upper))
    throw InputError(file.where(key), fmt::format("{} starts a fit at {:g} {}", p.name, value, p.unit),
                     fmt::format("{:g} to {:g}", p.lower, p.upper));
  if (name == "k_muscle" && file.scenario.tissue.paralysed == Side::both)
    throw InputError(file.where("paralysis.side"), "k_muscle has no effect if both sides are paralysed",
                     "k_muscle fixed");
}

std::vector<std::string> check_names(const FitPlan& plan, Mistakes& mistakes) {
  std::vector<std::string> fixed, free;
  for (const std::string& text : plan.fixed) mistakes.gather([&] { fixed.push_back(check_fixed(text)); });
  const auto is_fixed = [&](const std::string& name) {
    return std::count(fixed.begin(), fixed.end(), name) > 0;
  };
  for (const std::string& text : plan.free)
    mistakes.gather([&] {
      for (const std::string& name : parameter_names({text})) free.push_back(name);
    });
  for (const std::string& name : free) {
    if (is_fixed(name))
      mistakes.add({{}, "parameter '" + name + "' is both free and fixed", "one of the two", "", {}});
    if (std::count(free.begin(), free.end(), name) > 1)
      mistakes.add({{}, "parameter '" + name + "' is named twice", "every name once", "", {}});
  }
  if (!plan.free.empty()) return free;
  free = {"k_elasticity", "k_muscle"};  // as fit does from a trace
  std::erase_if(free, is_fixed);
  if (free.empty())
    mistakes.add({{}, "no parameter is free", "at least one: --free k_elasticity,k_muscle", "", {}});
  return free;
}

}  // namespace

void check_fit(const FitRequest& request, const std::optional<ScenarioFile>& file, Mistakes& mistakes) {
  const bool measured = !request.trace.empty() || request.tidal_volume_ml != 0.0;
  const FitPlan& plan = request.plan;
  if (!measured && plan.free.empty() && plan.fixed.empty() && request.priors.empty()) return;  // no fit meant
  mistakes.gather([&] { plan_of(request); });
  for (const std::string& name : check_names(plan, mistakes))
    if (file) mistakes.gather([&] { check_free(name, *file); });
  // What is left only shows when the fit is set up.
  if (mistakes.empty() && file && measured) mistakes.gather([&] { FitJob(request, {}, {}); });
}

}  // namespace trunk
