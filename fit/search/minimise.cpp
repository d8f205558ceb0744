#include "search/minimise.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

using Optimiser = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)>;

nlopt_algorithm algorithm_named(const std::string& name) {
  static const std::map<std::string, nlopt_algorithm> known = {{"bobyqa", NLOPT_LN_BOBYQA},
                                                               {"cobyla", NLOPT_LN_COBYLA},
                                                               {"neldermead", NLOPT_LN_NELDERMEAD},
                                                               {"sbplx", NLOPT_LN_SBPLX}};
  const auto at = known.find(name);
  if (at == known.end())
    throw InputError("unknown algorithm '" + name + "', expected bobyqa, cobyla, neldermead or sbplx");
  return at->second;
}

/// What crosses the C interface: exceptions wait here until NLopt has returned, since it would drop them.
struct Call {
  Objective& objective;
  const std::function<bool()>& cancelled;
  Eigen::VectorXd lower, upper;
  nlopt_opt optimiser;
  std::exception_ptr error = nullptr;
  bool was_cancelled = false;
};

double call_objective(unsigned n, const double* x, double*, void* data) noexcept {
  Call& call = *static_cast<Call*>(data);
  try {
    if (call.cancelled && call.cancelled()) {
      call.was_cancelled = true;
      nlopt_force_stop(call.optimiser);
      return 0.0;
    }
    // BOBYQA may leave the bounds by round-off.
    const Eigen::VectorXd at = Eigen::VectorXd::Map(x, n).cwiseMax(call.lower).cwiseMin(call.upper);
    return call.objective(at);
  } catch (...) {
    call.error = std::current_exception();
    nlopt_force_stop(call.optimiser);
    return 0.0;
  }
}

std::string reason(nlopt_result result, const SearchOptions& o) {
  switch (result) {
    case NLOPT_XTOL_REACHED:
      return fmt::format("every step in log coordinates is at most {:g}", o.coordinate_tolerance);
    case NLOPT_FTOL_REACHED:
      return fmt::format("the objective changes by at most {:g} of itself", o.objective_tolerance);
    case NLOPT_MAXEVAL_REACHED: return fmt::format("{} evaluations were not enough", o.max_evaluations);
    case NLOPT_ROUNDOFF_LIMITED: return "round-off stopped further progress";
    case NLOPT_SUCCESS:
    case NLOPT_STOPVAL_REACHED: return "the search finished";
    default: return fmt::format("NLopt stopped with {}", nlopt_result_to_string(result));
  }
}

}  // namespace

SearchResult minimise(Objective& objective, const Eigen::VectorXd& start, const SearchOptions& options,
                      const std::function<bool()>& cancelled) {
  const auto n = static_cast<unsigned>(start.size());
  nlopt_algorithm algorithm = algorithm_named(options.algorithm);
  if (n == 1 && algorithm == NLOPT_LN_BOBYQA) algorithm = NLOPT_LN_SBPLX;  // BOBYQA needs two coordinates
  const Optimiser optimiser(nlopt_create(algorithm, n), &nlopt_destroy);
  nlopt_opt opt = optimiser.get();
  Call call{objective, cancelled, objective.space().lower(), objective.space().upper(), opt, nullptr, false};
  nlopt_set_lower_bounds(opt, call.lower.data());
  nlopt_set_upper_bounds(opt, call.upper.data());
  nlopt_set_min_objective(opt, &call_objective, &call);
  nlopt_set_xtol_abs1(opt, options.coordinate_tolerance);
  nlopt_set_ftol_rel(opt, options.objective_tolerance);
  nlopt_set_maxeval(opt, options.max_evaluations);
  nlopt_set_initial_step1(opt, options.first_step);

  Eigen::VectorXd x = start.cwiseMax(call.lower).cwiseMin(call.upper);
  double last = 0.0;  // NLopt's last value is not the best one: the objective keeps that
  const nlopt_result result = nlopt_optimize(opt, x.data(), &last);
  if (call.error) std::rethrow_exception(call.error);
  const Evaluation* best = objective.best();
  if (!best) return {false, x, 0.0, "no simulation completed"};
  const bool arrived = result > 0 && result != NLOPT_MAXEVAL_REACHED && result != NLOPT_MAXTIME_REACHED;
  return {(arrived || result == NLOPT_ROUNDOFF_LIMITED) && !call.was_cancelled, best->x, best->objective,
          call.was_cancelled ? "interrupted" : reason(result, options)};
}

Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start) {
  const SearchSpace& space = objective.space();
  const auto& measured = objective.target().delta_v;
  const auto peak = std::max_element(measured.begin(), measured.end());
  if (*peak <= 0.0) return start;
  const Eigen::Index at_peak = peak - measured.begin();
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (!space.is_ratio(i)) continue;
    const auto ratio = static_cast<Eigen::Index>(i);
    const double lowest = space.lower()[ratio], highest = space.upper()[ratio];
    Eigen::VectorXd x = start;
    for (int steps = 0; steps < 8; ++steps) {
      const auto residuals = objective.residuals(x);
      const double model = residuals ? (*residuals)[at_peak] + *peak : 4.0 * *peak;  // failed: far too strong
      if (std::abs(model / *peak - 1.0) < 0.02) return x;
      // The volume grows about as the ratio does.
      x[ratio] = std::clamp(x[ratio] + std::log(*peak / std::max(model, 0.02 * *peak)), lowest, highest);
    }
    return x;
  }
  return start;
}

}  // namespace trunk
