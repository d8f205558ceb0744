#include "subject/check_fit.hpp"

#include <fmt/format.h>

#include "subject/fit_draft.hpp"
#include "subject/fit_job.hpp"

namespace trunk {
namespace {

/// Refuses a parameter that cannot be fitted from this scenario. Timing starts from the trace, which may also
/// give the scenario a lung.
void require_use(const std::string& name, const ScenarioFile& file, bool traced) {
  const FreeParameter& p = free_parameter(name);
  if (p.of_lung && !file.scenario.lung_acts) {
    if (traced) return;
    throw no_lung({"--free " + name});
  }
  const double start = value_of(p, {file.scenario.parameters, file.scenario.activation});
  const bool starts_here = p.group == FreeParameter::Group::mechanics;
  if (starts_here && !(start >= p.lower && start <= p.upper))
    throw InputError(file.where(std::string(p.scenario_key)),
                     fmt::format("{} starts a fit at {:g} {}", p.name, start, p.unit),
                     fmt::format("{:g} to {:g} {}", p.lower, p.upper, p.unit));
  if (name == "k_muscle" && file.scenario.tissue.paralysed == Side::both)
    throw InputError(file.where("paralysis.side"), "k_muscle has no effect if both sides are paralysed",
                     "k_muscle fixed");
}

}  // namespace

void check_fit(const FitRequest& request, const std::optional<ScenarioFile>& file, Mistakes& mistakes) {
  const bool measured = !request.trace.empty() || request.tidal_volume_ml != 0.0;
  const FitPlan& plan = request.plan;
  if (!measured && plan.free.empty() && plan.fixed.empty() && request.priors.empty()) return;  // no fit meant
  mistakes.gather([&] { plan_of(request); });
  std::vector<FixedParameter> fixed;
  for (const std::string& text : plan.fixed) mistakes.gather([&] { fixed.push_back(fixed_parameter(text)); });
  for (const std::string& name : names_to_fit(plan.free, fixed, request.trace.empty() && measured, mistakes))
    if (file) mistakes.gather([&] { require_use(name, *file, !request.trace.empty()); });
  // The rest only shows when the fit is set up.
  if (mistakes.empty() && file && measured) mistakes.gather([&] { FitJob(request, {}, {}); });
}

}  // namespace trunk
