#include "compartment/one_compartment.hpp"

#include <gsl/gsl_min.h>

#include <cmath>
#include <memory>

#include "search/minimise.hpp"

namespace trunk {
namespace {

constexpr double step_s = 2e-3;
constexpr double slowest_rate = 0.05, fastest_rate = 50.0;  // 1/s

/// Returns V(t) for unit drive at the measured times, exact for an activation that is constant within a step.
Eigen::VectorXd unit_response(double rate, const MeasuredCurve& curve,
                              const BreathActivation<double>& activation) {
  const auto steps = static_cast<std::size_t>(std::ceil(curve.time_s.back() / step_s)) + 1;
  const double decay = std::exp(-rate * step_s), gain = (1.0 - decay) / rate;
  std::vector<double> volume{0.0};
  for (std::size_t n = 0; n < steps; ++n)
    volume.push_back(decay * volume.back() + gain * activation((static_cast<double>(n) + 0.5) * step_s));
  return sampled(volume, step_s, curve.time_s);
}

struct Problem {
  const MeasuredCurve& curve;
  const BreathActivation<double> activation;

  OneCompartment at(double rate) const {
    const Eigen::VectorXd unit = unit_response(rate, curve, activation);
    const Eigen::VectorXd measured =
        Eigen::VectorXd::Map(curve.delta_v.data(), static_cast<Eigen::Index>(curve.delta_v.size()));
    const double drive = unit.dot(measured) / std::max(unit.squaredNorm(), 1e-300);
    const Eigen::VectorXd residuals = drive * unit - measured;
    return {drive, rate, residuals.squaredNorm(), residuals};
  }
};

double residual_sum(double log_rate, void* problem) {
  return static_cast<const Problem*>(problem)->at(std::exp(log_rate)).residual_sum;
}

/// Returns the best of a coarse grid of log rates: GSL needs a point that is lower than both ends of its
/// bracket.
double best_on_grid(Problem& problem, double low, double high, double spacing) {
  double best = low, lowest = residual_sum(low, &problem);
  double x = low + spacing;
  while (x <= high) {
    if (const double value = residual_sum(x, &problem); value < lowest) {
      best = x;
      lowest = value;
    }
    x += spacing;
  }
  return best;
}

}  // namespace

OneCompartment fit_one_compartment(const MeasuredCurve& curve, const BreathActivation<double>& activation) {
  const double low = std::log(slowest_rate), high = std::log(fastest_rate), spacing = 0.1;
  Problem problem{curve, activation};
  double best = best_on_grid(problem, low, high, spacing);
  if (best > low + spacing && best < high - spacing) {
    gsl_function function{&residual_sum, &problem};
    const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> search(
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_goldensection), &gsl_min_fminimizer_free);
    gsl_min_fminimizer_set(search.get(), &function, best, best - spacing, best + spacing);
    for (int i = 0; i < 40; ++i) gsl_min_fminimizer_iterate(search.get());
    best = gsl_min_fminimizer_x_minimum(search.get());
  }
  return problem.at(std::exp(best));
}

BreathActivation<double> timed_by_one_compartment(const MeasuredCurve& curve,
                                                  const BreathActivation<double>& start) {
  const auto timed = [&](const Eigen::VectorXd& x) {
    BreathActivation<double> a = start;
    a.rise_s = std::exp(x[0]);
    a.fast_fall_s = std::exp(x[1]);
    a.slow_fall_s = std::exp(x[2]);
    return a;
  };
  const auto outcomes = [&](const std::vector<Eigen::VectorXd>& some) {
    std::vector<Outcome> all;
    for (const Eigen::VectorXd& x : some)
      all.push_back({std::nullopt, Problem{curve, timed(x)}.at(std::exp(x[3])).residual_sum});
    return all;
  };
  const double shortest = std::log(0.02), longest = std::log(curve.time_s.back());
  const LeastSquares problem{outcomes, Eigen::Vector4d(shortest, shortest, shortest, std::log(slowest_rate)),
                             Eigen::Vector4d(longest, longest, longest, std::log(fastest_rate))};
  SearchOptions options;
  options.algorithm = "sbplx";  // the sum of squares has corners where a knot passes a sample
  options.coordinate_tolerance = 1e-4;
  options.objective_tolerance = 1e-9;
  options.max_evaluations = 3000;
  const double usual_rate = 4.0;  // 1/s: a time constant of a quarter of a second
  const Eigen::Vector4d x(std::log(start.rise_s), std::log(start.fast_fall_s), std::log(start.slow_fall_s),
                          std::log(usual_rate));
  return timed(minimise(problem, x, options).best);
}

}  // namespace trunk
