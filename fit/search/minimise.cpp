#include "search/minimise.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

using Optimiser = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)>;

struct Algorithm {
  const char* name;
  nlopt_algorithm nlopt;
  bool global = false;
};

constexpr Algorithm algorithms[] = {
    {"bobyqa", NLOPT_LN_BOBYQA},
    {"sbplx", NLOPT_LN_SBPLX},
    {"cobyla", NLOPT_LN_COBYLA},
    {"neldermead", NLOPT_LN_NELDERMEAD},
    {"lbfgs", NLOPT_LD_LBFGS},
    {"slsqp", NLOPT_LD_SLSQP},
    {"mma", NLOPT_LD_MMA},
    {"mlsl", NLOPT_G_MLSL_LDS, true},
    {"direct", NLOPT_GN_DIRECT_L, true},
};

const Algorithm& algorithm_named(const std::string& name) {
  for (const Algorithm& a : algorithms)
    if (a.name == name) return a;
  throw InputError({"--algorithm"}, "unknown algorithm '" + name + "'", algorithm_names());
}

/// The state behind the C interface. NLopt would lose an exception, so it is kept here until NLopt returns.
struct Call {
  const LeastSquares& problem;
  nlopt_opt optimiser;
  Eigen::VectorXd best;
  double lowest = std::numeric_limits<double>::infinity();
  int evaluations = 0;
  std::exception_ptr error = nullptr;

  double value(const Eigen::VectorXd& x, double* gradient) {
    const Outcome outcome = problem.at(x);
    ++evaluations;
    if (outcome.objective < lowest) {
      lowest = outcome.objective;
      best = x;
    }
    if (gradient != nullptr) write_gradient(x, outcome, gradient);
    return outcome.objective;
  }

  void write_gradient(const Eigen::VectorXd& x, const Outcome& outcome, double* gradient) {
    auto out = Eigen::VectorXd::Map(gradient, x.size());
    if (!outcome.residuals) {  // the value is a penalty, so no search stays here
      out.setZero();
      return;
    }
    const Slopes j = slopes_at(problem, x);
    evaluations += problem.exact_slopes ? 1 : static_cast<int>(x.size());
    if (!j) throw std::runtime_error("the model fails where a gradient is needed: try --algorithm bobyqa");
    out = 2.0 * j->transpose() * *outcome.residuals;
  }
};

double call_objective(unsigned n, const double* x, double* gradient, void* data) noexcept {
  Call& call = *static_cast<Call*>(data);
  try {
    // BOBYQA can leave the bounds by a rounding error.
    return call.value(call.problem.inside(Eigen::VectorXd::Map(x, n)), gradient);
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
      return fmt::format("the objective changes by a fraction of at most {:g}", o.objective_tolerance);
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

void set_up(nlopt_opt opt, const SearchOptions& options, Call& call) {
  nlopt_set_lower_bounds(opt, call.problem.lower.data());
  nlopt_set_upper_bounds(opt, call.problem.upper.data());
  nlopt_set_min_objective(opt, &call_objective, &call);
  nlopt_set_xtol_abs1(opt, options.coordinate_tolerance);
  nlopt_set_ftol_rel(opt, options.objective_tolerance);
  nlopt_set_maxeval(opt, options.max_evaluations);
  nlopt_set_initial_step1(opt, options.first_step);
}

SearchResult run(const LeastSquares& problem, const Eigen::VectorXd& start, const Algorithm& algorithm,
                 const SearchOptions& options) {
  const auto n = static_cast<unsigned>(start.size());
  const Optimiser optimiser(nlopt_create(algorithm.nlopt, n), &nlopt_destroy);
  Call call{problem, optimiser.get(), start};
  set_up(optimiser.get(), options, call);
  if (algorithm.nlopt == NLOPT_G_MLSL_LDS) {
    const Optimiser local(nlopt_create(n == 1 ? NLOPT_LN_SBPLX : NLOPT_LN_BOBYQA, n), &nlopt_destroy);
    nlopt_set_xtol_abs1(local.get(), 1e-3);
    nlopt_set_local_optimizer(optimiser.get(), local.get());
  }
  Eigen::VectorXd x = problem.inside(start);
  double last = 0.0;
  nlopt_srand(options.seed);
  const nlopt_result result = nlopt_optimize(optimiser.get(), x.data(), &last);
  if (call.error) std::rethrow_exception(call.error);
  const bool arrived = result == NLOPT_ROUNDOFF_LIMITED ||
                       (result > 0 && result != NLOPT_MAXEVAL_REACHED && result != NLOPT_MAXTIME_REACHED);
  return {arrived, call.best, call.lowest, reason(result, options), call.evaluations};
}

}  // namespace

std::string algorithm_names() {
  std::string names;
  for (const Algorithm& a : algorithms) names += std::string(a.name) + ", ";
  return names + "or lm";
}

void require_algorithm(const std::string& name) {
  if (name != "lm") algorithm_named(name);
}

SearchResult minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                      const SearchOptions& options) {
  if (options.algorithm == "lm") return levenberg_marquardt(problem, start, options);
  Algorithm algorithm = algorithm_named(options.algorithm);
  const bool single = start.size() == 1;  // BOBYQA needs two coordinates
  if (single && algorithm.nlopt == NLOPT_LN_BOBYQA) algorithm.nlopt = NLOPT_LN_SBPLX;
  SearchResult result = run(problem, start, algorithm, options);
  if (!algorithm.global) return result;
  SearchOptions local = options;
  local.first_step *= 0.1;
  const Algorithm polish = algorithm_named(single ? "sbplx" : "bobyqa");
  SearchResult polished = run(problem, result.best, polish, local);
  polished.evaluations += result.evaluations;
  return polished;
}

}  // namespace trunk
