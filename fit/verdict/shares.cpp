#include "verdict/shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

/// Returns what the reader calls a prior of this name.
std::string source_of(const std::string& name) {
  if (name.starts_with("shape")) return "shape";
  for (const FreeParameter& p : free_parameters()) {
    if (p.name != name) continue;
    const bool timing = p.group == FreeParameter::Group::timing || name == "fast_fall_level";
    return timing ? "timing" : "prior of " + name;
  }
  return name == "energy of expiration" ? name : "prior of " + name;
}

void add(const Share& share, std::vector<Share>& shares) {
  const auto at =
      std::find_if(shares.begin(), shares.end(), [&](const Share& s) { return s.source == share.source; });
  if (at == shares.end()) return shares.push_back(share);
  at->part += share.part;
  at->pull = std::max(at->pull, share.pull);
}

}  // namespace

std::vector<Share> shares_of(const FitProblem& problem, const LocalFit& fit,
                             const Eigen::VectorXd& gradient) {
  const Eigen::VectorXd weights = fit.rows * (fit.unit_covariance * gradient);
  const double all = std::max(weights.squaredNorm(), 1e-300);
  std::vector<Share> shares;
  for (std::size_t b = 0; b < fit.blocks.size(); ++b) {
    const double part = weights.segment(fit.blocks[b].first, fit.blocks[b].count).squaredNorm() / all;
    add({b == 0 ? "volume" : std::string(words_of(problem.measured.beside[b - 1].kind)), part, true}, shares);
  }
  Eigen::Index row = fit.blocks.back().first + fit.blocks.back().count;
  const auto add_prior = [&](const std::string& name, double residual) {
    add({source_of(name), weights[row] * weights[row] / all, false, std::abs(residual)}, shares);
    ++row;
  };
  const std::vector<std::string> names = problem.space.prior_names();
  const Eigen::VectorXd residuals = problem.space.prior_residuals(fit.x);
  for (std::size_t i = 0; i < names.size(); ++i) add_prior(names[i], residuals[static_cast<Eigen::Index>(i)]);
  for (const KnownFact& fact : problem.knowledge)
    add_prior(fact.name, fact.residual(problem.space.decode(fit.x)));
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.part > b.part; });
  return shares;
}

double prior_part(const std::vector<Share>& shares) {
  double sum = 0.0;
  for (const Share& s : shares)
    if (!s.measured) sum += s.part;
  return sum;
}

std::string text_of(const std::vector<Share>& shares) {
  std::string text;
  for (const Share& s : shares)
    if (s.part >= 0.01)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", s.source, 100.0 * s.part);
  return text;
}

}  // namespace trunk
