#pragma once

#include "uncertainty/uncertainty.hpp"
#include "verdict/fit_results.hpp"

namespace trunk {

/// A number that follows from a candidate.
using Reading = std::function<double(const Candidate&)>;

/// Returns the derivative of a reading by each coordinate at x, by central differences.
Eigen::VectorXd gradient_of(const Reading& reading, const SearchSpace& space, const Eigen::VectorXd& x);

/// Returns the standard deviation that a covariance of the coordinates gives to a reading.
double deviation_of(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& covariance);

/// Returns the highest volume of the compartment above its start, m3.
double tidal_volume(const TrunkAsCompartment& compartment, const Candidate& candidate, const TimeGrid& grid,
                    const MeasuredCurve& measured);

/// Returns the volume of the compartment above relaxation as a breath begins, m3.
double above_relaxation(const TrunkAsCompartment& compartment, const Candidate& candidate,
                        const TimeGrid& grid, const MeasuredCurve& measured);

/// Returns k_muscle A / k_elasticity at end-inspiration. No air flows there, so the muscle holds the volume:
/// it is the volume above relaxation over what full activation holds.
double muscle_against_recoil(const TrunkAsCompartment& compartment, const Candidate& candidate,
                             const TimeGrid& grid, const MeasuredCurve& measured);

}  // namespace trunk
