#include "compartment/one_compartment.hpp"

#include <gsl/gsl_min.h>

#include <cmath>
#include <memory>

namespace trunk {
namespace {

constexpr double shortest_s = 0.02, longest_s = 20.0;

struct Problem {
  const MeasuredCurve& curve;
  const BreathActivation<double>& activation;
  const TimeGrid& grid;

  OneCompartment at(double time_constant_s) const {
    const auto n = static_cast<Eigen::Index>(curve.delta_v.size());
    const CompartmentBreath breath =
        compartment_breath({time_constant_s, 1.0}, activation, grid, curve.time_s);
    const Eigen::VectorXd unit = Eigen::VectorXd::Map(breath.delta_v.data(), n),
                          measured = Eigen::VectorXd::Map(curve.delta_v.data(), n);
    const double gain = unit.dot(measured) / std::max(unit.squaredNorm(), 1e-300);
    const Eigen::VectorXd residuals = gain * unit - measured;
    return {{time_constant_s, gain}, residuals.squaredNorm(), residuals};
  }
};

double residual_sum(double log_time_constant, void* problem) {
  return static_cast<const Problem*>(problem)->at(std::exp(log_time_constant)).residual_sum;
}

/// Returns the best of a coarse grid of logarithms: GSL needs a point that is lower than both ends of its
/// bracket.
double best_on_grid(Problem& problem, double low, double high, double spacing) {
  double best = low, lowest = residual_sum(low, &problem);
  const auto points = static_cast<int>((high - low) / spacing);
  for (int i = 1; i <= points; ++i) {
    const double x = low + i * spacing, value = residual_sum(x, &problem);
    if (value >= lowest) continue;
    best = x;
    lowest = value;
  }
  return best;
}

}  // namespace

OneCompartment fit_one_compartment(const MeasuredCurve& curve, const BreathActivation<double>& activation,
                                   const TimeGrid& grid) {
  const double low = std::log(shortest_s), high = std::log(longest_s), spacing = 0.1;
  Problem problem{curve, activation, grid};
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

}  // namespace trunk
