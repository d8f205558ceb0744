#include "verdict/draws.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "compartment/compartment_model.hpp"
#include "linear_algebra/decompositions.hpp"
#include "search/multistart.hpp"

namespace trunk {
namespace {

/// Returns how far the coordinates are from the best point at a recoil time.
Eigen::VectorXd moved_along(const AlongRecoil& along, const Eigen::VectorXd& best, double log_time) {
  const auto& refits = along.refits;
  const double reach = 0.1 * (refits.back().first - refits.front().first);
  const double at = std::clamp(log_time, refits.front().first - reach, refits.back().first + reach);
  std::size_t next = 1;
  while (next + 1 < refits.size() && at > refits[next].first) ++next;
  const auto& [t0, x0] = refits[next - 1];
  const auto& [t1, x1] = refits[next];
  return x0 + (at - t0) / (t1 - t0) * (x1 - x0) - best;
}

}  // namespace

std::vector<Candidate> posterior_draws(const Posterior& p, const SearchSpace& space, std::size_t count,
                                       unsigned seed,
                                       const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& settle) {
  const auto n = static_cast<Eigen::Index>(space.size());
  const SymmetricEigen eigen = symmetric_eigen(p.covariance);
  const Eigen::MatrixXd root = eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::VectorXd lower = space.lower(), upper = space.upper();
  const LeastSquares cube{{}, Eigen::VectorXd::Zero(n + 5), Eigen::VectorXd::Ones(n + 5)};
  std::vector<Candidate> draws;
  for (Eigen::VectorXd part : sobol_starts(cube, count, seed)) {
    part = part.cwiseMax(1e-9).cwiseMin(1.0 - 1e-9);
    // The sequence is most even in its first dimensions: these go where the fit is least certain.
    const double share = part[0], gain = gsl_cdf_ugaussian_Pinv(part[1]);
    const Eigen::VectorXd normal = part.segment(2, n).unaryExpr(&gsl_cdf_ugaussian_Pinv).reverse();
    const double spread = std::sqrt(p.freedom / gsl_cdf_chisq_Pinv(part[n + 2], p.freedom));
    Eigen::VectorXd x = p.x + spread * (root * normal);
    if (p.along) {
      const double log_time = std::log(recoil_time_s(p.along->energy, p.along->share.share_at(share))) +
                              p.along->log_error * gsl_cdf_tdist_Pinv(part[n + 3], p.along->freedom) +
                              TrunkAsCompartment::log_error * gsl_cdf_ugaussian_Pinv(part[n + 4]);
      x += moved_along(*p.along, p.x, log_time);
    }
    if (settle) x = settle(x);
    if (const auto muscle = space.find("k_muscle"))
      x[static_cast<Eigen::Index>(*muscle)] += p.volume_error * gain;
    draws.push_back(space.decode(x.cwiseMax(lower).cwiseMin(upper)));
  }
  return draws;
}

}  // namespace trunk
