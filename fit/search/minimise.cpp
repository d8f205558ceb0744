#include "search/minimise.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <exception>
#include <limits>
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
  const SearchProblem& problem;
  const std::function<bool()>& cancelled;
  nlopt_opt optimiser;
  Eigen::VectorXd best;
  double lowest = std::numeric_limits<double>::infinity();
  std::exception_ptr error = nullptr;
  bool was_cancelled = false;

  double operator()(const Eigen::VectorXd& x) {
    const double value = problem.value(x);
    if (value < lowest) {
      lowest = value;
      best = x;
    }
    return value;
  }
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
    return call(Eigen::VectorXd::Map(x, n).cwiseMax(call.problem.lower).cwiseMin(call.problem.upper));
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
    case NLOPT_MAXEVAL_REACHED:
      return fmt::format("{} evaluations were not enough", o.max_evaluations);
    case NLOPT_ROUNDOFF_LIMITED:
      return "round-off stopped further progress";
    case NLOPT_SUCCESS:
    case NLOPT_STOPVAL_REACHED:
      return "the search finished";
    default:
      return fmt::format("NLopt stopped with {}", nlopt_result_to_string(result));
  }
}

}  // namespace

SearchResult minimise(const SearchProblem& problem, const Eigen::VectorXd& start,
                      const SearchOptions& options, const std::function<bool()>& cancelled) {
  const auto n = static_cast<unsigned>(start.size());
  nlopt_algorithm algorithm = algorithm_named(options.algorithm);
  if (n == 1 && algorithm == NLOPT_LN_BOBYQA) algorithm = NLOPT_LN_SBPLX;  // BOBYQA needs two coordinates
  const Optimiser optimiser(nlopt_create(algorithm, n), &nlopt_destroy);
  nlopt_opt opt = optimiser.get();
  Call call{problem, cancelled, opt, start};
  nlopt_set_lower_bounds(opt, problem.lower.data());
  nlopt_set_upper_bounds(opt, problem.upper.data());
  nlopt_set_min_objective(opt, &call_objective, &call);
  nlopt_set_xtol_abs1(opt, options.coordinate_tolerance);
  nlopt_set_ftol_rel(opt, options.objective_tolerance);
  nlopt_set_maxeval(opt, options.max_evaluations);
  nlopt_set_initial_step1(opt, options.first_step);

  Eigen::VectorXd x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  double last = 0.0;
  const nlopt_result result = nlopt_optimize(opt, x.data(), &last);
  if (call.error) std::rethrow_exception(call.error);
  if (call.was_cancelled) return {false, call.best, call.lowest, "interrupted"};
  const bool arrived = result == NLOPT_ROUNDOFF_LIMITED ||
                       (result > 0 && result != NLOPT_MAXEVAL_REACHED && result != NLOPT_MAXTIME_REACHED);
  return {arrived, call.best, call.lowest, reason(result, options)};
}

}  // namespace trunk
