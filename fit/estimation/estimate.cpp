#include "estimation/estimate.hpp"

#include "estimation/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

/// The highest sample's place in a curve.
std::size_t peak_of(const double* values, std::size_t count) {
  return static_cast<std::size_t>(std::max_element(values, values + count) - values);
}

Quality quality_of(const Target& target, const Eigen::VectorXd& model,
                   const BreathActivation<double>& activation) {
  Quality q;
  const auto n = target.delta_v.size();
  const auto count = static_cast<Eigen::Index>(n);
  const Eigen::VectorXd measured = Eigen::VectorXd::Map(target.delta_v.data(), count);
  q.tidal_volume_m3 = measured.maxCoeff();
  const auto normalised = [&](double sum_of_squares) {
    return std::sqrt(sum_of_squares / static_cast<double>(n)) / q.tidal_volume_m3;
  };
  q.nrmse = normalised((model - measured).squaredNorm());
  q.tidal_volume_error_m3 = model.maxCoeff() - q.tidal_volume_m3;
  if (target.is_tidal_volume()) return q;
  q.peak_time_error_s = target.time_s[peak_of(model.data(), n)] - target.time_s[peak_of(measured.data(), n)];
  q.baseline_nrmse = normalised(fit_one_compartment(target, activation).residual_sum);
  return q;
}

/// Numbers from a model that misses the breath deserve a warning, however narrow their intervals.
std::string caveat(const Quality& q) {
  const double usual = 0.05;
  if (q.baseline_nrmse <= 0.0 || q.nrmse < std::max(usual, 2.0 * q.baseline_nrmse)) return "";
  return fmt::format(
      " The model follows this breath poorly ({:.1f} % of tidal volume, a one-compartment model {:.1f} %): "
      "trust its "
      "numbers less than their intervals say.",
      100.0 * q.nrmse, 100.0 * q.baseline_nrmse);
}

SearchResult search_twice(Objective& objective, const Eigen::VectorXd& start, SearchOptions options,
                          const std::function<bool()>& cancelled) {
  const SearchProblem problem{[&](const Eigen::VectorXd& x) { return objective(x); },
                              objective.space().lower(), objective.space().upper()};
  const Eigen::VectorXd near = start_at_tidal_volume(objective, start);
  const SearchResult first = minimise(problem, near, options, cancelled);
  if (!first.converged) return first;
  options.first_step *= 0.1;
  return minimise(problem, first.best, options, cancelled);
}

}  // namespace

Target target_of(const MeasuredBreath& breath) {
  return {breath.time_s, breath.volume_m3};
}

void adopt_timing(const MeasuredBreath& breath, Scenario& scenario) {
  auto& a = scenario.activation;
  const std::size_t peak = peak_of(breath.volume_m3.data(), breath.volume_m3.size());
  const double level = a.fast_fall_level * breath.volume_m3[peak];
  std::size_t fallen = peak;
  while (fallen + 1 < breath.volume_m3.size() && breath.volume_m3[fallen] > level) ++fallen;
  const double shortest_s = 0.02;
  a.onset_s = 0.0;
  a.period_s = 0.0;
  a.rise_s = std::max(shortest_s, breath.time_s[peak]);
  a.fast_fall_s = std::max(shortest_s, breath.time_s[fallen] - breath.time_s[peak]);
  a.slow_fall_s = std::max(shortest_s, breath.duration_s - breath.time_s[fallen]);
  a = timed_by_one_compartment(target_of(breath), a);
}

Estimation estimate(const Trunk& trunk, const Scenario& scenario, const SearchSpace& space,
                    const Target& target, const EstimationOptions& options,
                    const std::function<bool()>& cancelled) {
  Objective objective(trunk, scenario.time, space, target);
  Estimation e;
  e.search = search_twice(objective, space.start(), options.search, cancelled);
  if (const Evaluation* best = objective.best()) {
    const Eigen::VectorXd x = best->x;  // a copy: more evaluations follow
    e.best = space.decode(x);
    const VolumeCurve curve = simulate_volume(trunk, e.best.parameters, e.best.activation, scenario.time);
    e.model = as_target_sees(target, curve.delta_v, scenario.time.dt_s);
    e.quality = quality_of(target, e.model, e.best.activation);
    if (e.search.converged) {
      e.uncertainty = assess(objective, x, options.timing_from_trace);
      e.uncertainty->verdict += caveat(e.quality);
    }
  }
  e.evaluations = objective.evaluations();
  e.failures = objective.failures();
  return e;
}

}  // namespace trunk
