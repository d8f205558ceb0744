#include "subject/each_breath.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace trunk {
namespace {

/// Returns the plan for a single breath, of which k_muscle alone is fitted.
FitPlan plan_of_breath(const SubjectFit& fit, const Candidate& best) {
  FitPlan plan = fit.plan();
  plan.free = {"k_muscle"};
  for (std::string& text : plan.fixed) {  // as values, so that no file is read again
    const std::string name = text.substr(0, text.find('='));
    text = fmt::format("{}={:.17g}", name, value_of(free_parameter(name), best));
  }
  std::erase_if(plan.priors, [&](const Prior& p) {
    const auto at = fit.space().find(p.name);
    return p.name != "k_muscle" && at && *at < fit.space().asked_for();
  });
  EstimationOptions& options = plan.estimation;
  options.search.algorithm = "lm";
  options.profiles = false;
  options.surface_points = options.bootstrap = 0;
  // Once the sum of squares is this flat, k_muscle is within a twentieth of its standard error.
  options.search.objective_tolerance = 1e-5;
  options.execution.progress = {};
  return plan;
}

BreathRefit row_of(const Estimation& e) {
  BreathRefit row;
  row.status = e.search.converged ? "converged" : "not_converged";
  row.nrmse = e.quality.nrmse;
  row.evaluations = e.evaluations.size();
  const double unknown = std::nan("");
  row.muscle = {"k_muscle", "N/m", e.best.parameters.muscle, unknown, unknown, unknown};
  if (e.uncertainty) row.muscle = e.uncertainty->parameters.front();
  return row;
}

BreathRefit failed(const std::string& error) {
  BreathRefit row;
  row.status = "failed";
  row.error = error;
  const double unknown = std::nan("");
  row.muscle = {"k_muscle", "N/m", unknown, unknown, unknown, unknown};
  row.nrmse = std::nan("");
  return row;
}

}  // namespace

std::vector<BreathRefit> refit_each_breath(const SubjectFit& fit, const Estimation& e,
                                           const Segmentation& segmentation,
                                           const std::function<void(std::size_t)>& report) {
  const FitPlan plan = plan_of_breath(fit, e.best);
  ScenarioFile file = fit.fitted(e);
  double tidal_volume_m3 = fit.measurement().breath->tidal_volume_m3;  // of the breath before
  std::vector<BreathRefit> rows;
  for (std::size_t k = 0; k < segmentation.breaths.size(); ++k) {
    if (!segmentation.breaths[k].kept) continue;
    const auto start = std::chrono::steady_clock::now();
    BreathRefit row;
    try {
      const MeasuredBreath breath = single_breath(segmentation, k + 1);
      ScenarioFile warm = file;
      warm.scenario.parameters.muscle *= breath.tidal_volume_m3 / tidal_volume_m3;
      const SubjectFit one(warm, {breath, 0.0}, plan);
      Ledger ledger;
      const Estimation found = one.carry_out(ledger);
      row = found.model.size() > 0 ? row_of(found) : failed(found.search.stop_reason);
      if (found.search.converged) {
        file.scenario.parameters.muscle = found.best.parameters.muscle;
        tidal_volume_m3 = breath.tidal_volume_m3;
      }
    } catch (const std::exception& error) {
      row = failed(error.what());
    }
    row.number = k + 1;
    row.onset_s = segmentation.breaths[k].onset_s;
    row.tidal_volume_m3 = segmentation.breaths[k].tidal_volume_m3;
    row.latency_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rows.push_back(std::move(row));
    if (report) report(rows.size());
  }
  return rows;
}

}  // namespace trunk
