#include "sheet/ring_weights.hpp"

#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

constexpr double strong = 30.0, weak = 0.15, least = 0.15;

/// Returns the minimum of 1/2 x . H x - g . x over x >= 0, for a positive definite H (Lawson & Hanson 1974,
/// Solving Least Squares Problems, algorithm NNLS).
Eigen::VectorXd bounded_minimum(const Eigen::MatrixXd& H, const Eigen::VectorXd& g) {
  const Eigen::Index n = g.size();
  const double round_off = 1e-12 * g.cwiseAbs().maxCoeff();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Index> free;
  const auto minimum_of_free = [&] {
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd part(count, count);
    Eigen::VectorXd right(count);
    for (Eigen::Index a = 0; a < count; ++a) {
      right[a] = g[free[static_cast<std::size_t>(a)]];
      for (Eigen::Index b = 0; b < count; ++b)
        part(a, b) = H(free[static_cast<std::size_t>(a)], free[static_cast<std::size_t>(b)]);
    }
    const Eigen::VectorXd found = solved_symmetric(part, right);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(n);
    for (Eigen::Index a = 0; a < count; ++a) all[free[static_cast<std::size_t>(a)]] = found[a];
    return all;
  };
  for (Eigen::Index round = 0; round < 3 * n; ++round) {
    Eigen::VectorXd downhill = g - H * x;
    for (const Eigen::Index i : free) downhill[i] = 0.0;
    Eigen::Index steepest = 0;
    if (downhill.maxCoeff(&steepest) <= round_off) break;
    free.push_back(steepest);
    for (;;) {
      const Eigen::VectorXd next = minimum_of_free();
      double share = 1.0;  // of the way to `next` that stays within the bound
      for (const Eigen::Index i : free)
        if (next[i] <= 0.0) share = std::min(share, x[i] / (x[i] - next[i]));
      x += share * (next - x);
      if (share == 1.0) break;
      std::erase_if(free, [&](Eigen::Index i) { return next[i] <= 0.0 && x[i] <= 1e-15; });
      for (Eigen::Index i = 0; i < n; ++i)
        if (std::find(free.begin(), free.end(), i) == free.end()) x[i] = 0.0;
    }
  }
  return x;
}

}  // namespace

std::vector<double> ring_weights(std::span<const Vec3d> offset, const Vec3d& normal) {
  const auto count = static_cast<Eigen::Index>(offset.size());
  const double even = 1.0 / static_cast<double>(count);
  std::vector<Vec3d> within;
  double square = 0.0;
  for (const Vec3d& r : offset) {
    within.push_back(r - dot(r, normal) * normal);
    square += even * dot(within.back(), within.back());
  }
  const Vec3d first = (1.0 / norm(within.front())) * within.front(), second = cross(normal, first);

  Eigen::MatrixXd rows(5, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Vec3d& r = within[static_cast<std::size_t>(j)];
    const double a = dot(r, first) / std::sqrt(square), b = dot(r, second) / std::sqrt(square);
    rows.col(j) << strong, strong * a, strong * b, a * a - b * b, 2.0 * a * b;
  }
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(5);
  wanted[0] = strong;
  const Eigen::VectorXd bound = Eigen::VectorXd::Constant(count, least * even);
  const Eigen::MatrixXd H = rows.transpose() * rows + weak * weak * Eigen::MatrixXd::Identity(count, count);
  const Eigen::VectorXd g =
      rows.transpose() * wanted + Eigen::VectorXd::Constant(count, weak * weak * even) - H * bound;
  const Eigen::VectorXd w = bound + bounded_minimum(H, g);
  std::vector<double> weights;
  for (Eigen::Index j = 0; j < count; ++j) weights.push_back(w[j] / w.sum());
  return weights;
}

}  // namespace trunk
