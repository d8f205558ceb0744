#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

#include "search/minimise.hpp"

namespace trunk {
namespace {

using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;

Eigen::VectorXd copied(const gsl_vector* v) {
  return Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>(
      v->data, static_cast<Eigen::Index>(v->size),
      Eigen::InnerStride<>(static_cast<Eigen::Index>(v->stride)));
}

/// The state behind the C interface. GSL has no bounds, so its coordinates u are mapped into them by a sine.
struct Fit {
  const LeastSquares& problem;
  Eigen::VectorXd middle, half;
  Eigen::VectorXd best;
  double lowest = std::numeric_limits<double>::infinity();
  int evaluations = 0;
  std::exception_ptr error = nullptr;
  Eigen::Index rows = 0;

  explicit Fit(const LeastSquares& p)
      : problem(p), middle(0.5 * (p.lower + p.upper)), half(0.5 * (p.upper - p.lower)) {}

  Eigen::VectorXd inside(const gsl_vector* u) const {
    return middle + half.cwiseProduct(copied(u).array().sin().matrix());
  }
  Outcome at(const Eigen::VectorXd& x) {
    Outcome outcome = problem.at(x);
    ++evaluations;
    if (outcome.objective < lowest) {
      lowest = outcome.objective;
      best = x;
    }
    // Large and finite residuals make GSL take back a step that led to a failed simulation.
    if (!outcome.residuals && rows > 0)
      outcome.residuals =
          Eigen::VectorXd::Constant(rows, std::sqrt(outcome.objective / static_cast<double>(rows)));
    return outcome;
  }
};

template <class Work>
int guarded(void* data, Work work) noexcept {
  Fit& fit = *static_cast<Fit*>(data);
  try {
    return work(fit);
  } catch (...) {
    fit.error = std::current_exception();
    return GSL_EBADFUNC;
  }
}

int residuals(const gsl_vector* u, void* data, gsl_vector* f) noexcept {
  return guarded(data, [&](Fit& fit) {
    const Outcome outcome = fit.at(fit.inside(u));
    for (Eigen::Index i = 0; i < fit.rows; ++i)
      gsl_vector_set(f, static_cast<std::size_t>(i), (*outcome.residuals)[i]);
    return static_cast<int>(GSL_SUCCESS);
  });
}

int slopes(const gsl_vector* u, void* data, gsl_matrix* j) noexcept {
  return guarded(data, [&](Fit& fit) {
    const Eigen::VectorXd angles = copied(u);
    const Slopes by_x = slopes_at(fit.problem, fit.inside(u));
    fit.evaluations += fit.problem.exact_slopes ? 1 : static_cast<int>(angles.size());
    if (!by_x) return static_cast<int>(GSL_EBADFUNC);
    const Eigen::MatrixXd by_u = *by_x * fit.half.cwiseProduct(angles.array().cos().matrix()).asDiagonal();
    for (Eigen::Index r = 0; r < by_u.rows(); ++r)
      for (Eigen::Index c = 0; c < by_u.cols(); ++c)
        gsl_matrix_set(j, static_cast<std::size_t>(r), static_cast<std::size_t>(c), by_u(r, c));
    return static_cast<int>(GSL_SUCCESS);
  });
}

/// Returns u for a start x, a little inside the bounds: on a bound sin(u) has no slope, so u could never
/// leave it.
Eigen::VectorXd angles_of(const Fit& fit, const Eigen::VectorXd& x) {
  const Eigen::ArrayXd part = ((x - fit.middle).array() / fit.half.array()).max(-0.999).min(0.999);
  return part.asin();
}

struct Ending {
  bool converged;
  std::string reason;
};

Ending iterate(gsl_multifit_nlinear_workspace* work, const Fit& fit, const SearchOptions& options) {
  const double step_tolerance = std::max(options.coordinate_tolerance, 1e-10);
  const double slope_tolerance = 1e-10;
  int small_gains = 0;
  while (fit.evaluations < options.max_evaluations) {
    const double before = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(work));
    const int status = gsl_multifit_nlinear_iterate(work);
    if (fit.error) std::rethrow_exception(fit.error);
    if (status == GSL_ENOPROG) return {true, "no step in any direction lowers the sum of squares"};
    if (status != GSL_SUCCESS) return {false, fmt::format("GSL stopped: {}", gsl_strerror(status))};
    int info = 0;
    const int done = gsl_multifit_nlinear_test(step_tolerance, slope_tolerance, 0.0, &info, work);
    if (done == GSL_SUCCESS)
      return {true, info == 1 ? fmt::format("the step is at most {:g} of the coordinates", step_tolerance)
                              : fmt::format("the gradient is at most {:g}", slope_tolerance)};
    const double after = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(work));
    small_gains = before - after <= 0.5 * options.objective_tolerance * after ? small_gains + 1 : 0;
    if (small_gains == 2)  // a single small gain may be chance
      return {true, fmt::format("the objective changes by a fraction of at most {:g}",
                                options.objective_tolerance)};
  }
  return {false, fmt::format("{} evaluations were not enough", options.max_evaluations)};
}

}  // namespace

SearchResult levenberg_marquardt(const LeastSquares& problem, const Eigen::VectorXd& start,
                                 const SearchOptions& options) {
  gsl_set_error_handler_off();
  Fit fit(problem);
  fit.best = problem.inside(start);
  const Outcome first = fit.at(fit.best);
  if (!first.residuals) return {false, fit.best, first.objective, "the model fails at the start", 1};
  fit.rows = first.residuals->size();
  if (fit.rows < start.size())
    return {false, fit.best, first.objective, "fewer residuals than parameters", 1};

  const auto n = static_cast<std::size_t>(fit.rows), p = static_cast<std::size_t>(start.size());
  const gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
  const Workspace work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, n, p),
                       &gsl_multifit_nlinear_free);
  gsl_multifit_nlinear_fdf functions{&residuals, &slopes, nullptr, n, p, &fit, 0, 0, 0};
  Eigen::VectorXd u = angles_of(fit, fit.best);
  const gsl_vector_view view = gsl_vector_view_array(u.data(), p);
  const int status = gsl_multifit_nlinear_init(&view.vector, &functions, work.get());
  if (fit.error) std::rethrow_exception(fit.error);
  if (status != GSL_SUCCESS)
    return {false, fit.best, fit.lowest, "the model fails close to the start", fit.evaluations};
  const Ending ending = iterate(work.get(), fit, options);
  return {ending.converged, fit.best, fit.lowest, ending.reason, fit.evaluations};
}

}  // namespace trunk
