#include "search/multistart.hpp"

#include <gsl/gsl_qrng.h>

#include <cmath>
#include <memory>
#include <random>

namespace trunk {

std::vector<Eigen::VectorXd> sobol_starts(const LeastSquares& problem, std::size_t count, unsigned seed) {
  const auto n = static_cast<unsigned>(std::min<Eigen::Index>(problem.size(), 40));
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(gsl_qrng_alloc(gsl_qrng_sobol, n),
                                                                     &gsl_qrng_free);
  // A shift modulo 1 (Cranley and Patterson 1976) makes the sequence depend on the seed and keeps it even.
  std::mt19937_64 engine(seed);
  std::vector<double> shift(n), point(n);
  for (double& s : shift) s = static_cast<double>(engine() >> 11) * 0x1p-53;
  std::vector<Eigen::VectorXd> starts;
  for (std::size_t k = 0; k < count; ++k) {
    gsl_qrng_get(sequence.get(), point.data());
    Eigen::VectorXd x = 0.5 * (problem.lower + problem.upper);
    for (unsigned i = 0; i < n; ++i) {
      const double part = point[i] + shift[i];
      x[i] = problem.lower[i] + (part - std::floor(part)) * (problem.upper[i] - problem.lower[i]);
    }
    starts.push_back(x);
  }
  return starts;
}

}  // namespace trunk
