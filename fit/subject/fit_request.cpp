#include "subject/fit_request.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// Refuses a setting that the trace would overwrite.
void require_no_timing(const FitRequest& request) {
  static constexpr std::string_view timed[] = {"activation.onset_s",     "activation.rise_s",
                                               "activation.fast_fall_s", "activation.slow_fall_s",
                                               "activation.period_s",    "time.duration_s"};
  for (const std::string& text : request.settings)
    for (std::string_view key : timed)
      if (setting_of(text).key == key)
        throw InputError({"--set " + text}, "the trace gives the timing", "--timing scenario beside it");
}

Loss loss_of(const std::string& name) {
  if (name == "huber") return Loss::huber;
  return name == "student" ? Loss::student : Loss::squares;
}

}  // namespace

Prior prior_of(const std::string& text) {
  const auto refuse = [&](const std::string& found) {
    return InputError(
        {"--prior " + text}, found,
        "name=MEAN:FACTOR, as in --prior k_elasticity=4000:1.5, name=:FACTOR around the start, or "
        "name=none");
  };
  const auto number = [&](const std::string& part) {
    double n = 0.0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), n);
    if (error != std::errc() || end != part.data() + part.size() || !std::isfinite(n))
      throw refuse("'" + part + "' is not a number");
    return n;
  };
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw refuse("there is no '='");
  const std::string named = text.substr(0, equals);
  // The abdominal elastance is no parameter, but it has a prior, and like most it is known by a factor.
  static constexpr FreeParameter elastance{.name = abdominal_elastance_prior,
                                           .unit = "cmH2O/L",
                                           .scenario_key = "",
                                           .lower = 0.1,
                                           .upper = 1000.0,
                                           .group = FreeParameter::Group::mechanics,
                                           .field = nullptr};
  const FreeParameter& p =
      named == abdominal_elastance_prior ? elastance : free_parameter(named, {"--prior " + text});
  const std::string value = text.substr(equals + 1);
  if (value == "none") return {std::string(p.name), {}, 0.0};
  const auto colon = value.find(':');
  if (colon == std::string::npos) throw refuse("there is no ':'");
  Prior prior{std::string(p.name), {}, number(value.substr(colon + 1))};
  if (colon > 0) prior.mean = number(value.substr(0, colon));
  const bool factor = p.scale == FreeParameter::Scale::factor;
  if (!(prior.deviation > (factor ? 1.0 : 0.0) && prior.deviation <= 1000.0))
    throw InputError(
        {"--prior " + text}, fmt::format("{:g} is out of bounds", prior.deviation),
        factor ? "a factor above 1, at most 1000" : "a standard deviation above 0, at most 1000");
  if (factor) prior.deviation = std::log(prior.deviation);
  return prior;
}

FitPlan plan_of(const FitRequest& request) {
  FitPlan plan = request.plan;
  for (const std::string& text : request.priors) plan.priors.push_back(prior_of(text));
  if (request.keep_timing || request.timing == "scenario")
    plan.timing = Timing::scenario;
  else
    plan.timing = request.timing == "trace" ? Timing::trace : Timing::joint;
  if (!request.trace.empty() && plan.timing != Timing::scenario) require_no_timing(request);
  plan.weighted = request.weights == "sigma";
  plan.estimation.loss = loss_of(request.loss);
  if (!plan.estimation.search.algorithm.empty()) require_algorithm(plan.estimation.search.algorithm);
  if (request.surface == 1 || request.surface == 2)
    throw InputError({fmt::format("--surface {}", request.surface)},
                     "a surface of so few points shows nothing",
                     "0 (none) or 3 to 200 points along each parameter");
  if (request.surface >= 0) plan.estimation.surface_points = request.surface;
  plan.straight = request.assume == "straight-activation";
  return plan;
}

}  // namespace trunk
