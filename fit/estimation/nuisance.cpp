#include "estimation/nuisance.hpp"

#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"
#include "search/minimise.hpp"

namespace trunk {

Indices all_but(const Indices& some, std::size_t count) {
  Indices others;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(count); ++i)
    if (std::find(some.begin(), some.end(), i) == some.end()) others.push_back(i);
  return others;
}

Eigen::VectorXd best_nuisance(const LeastSquares& compartment, const Eigen::VectorXd& at,
                              const Indices& kept) {
  const Indices nuisance = all_but(kept, static_cast<std::size_t>(at.size()));
  Eigen::VectorXd best = at;
  if (nuisance.empty()) return best;
  const LeastSquares part = with_fixed(compartment, at, nuisance);
  SearchOptions options;
  options.objective_tolerance = 1e-9;
  options.max_evaluations = 200;
  best(nuisance) = levenberg_marquardt(part, at(nuisance), options).best;
  return best;
}

WithoutNuisance::WithoutNuisance(Objective& trunk, Objective& compartment, const Eigen::VectorXd& at,
                                 const Indices& kept)
    : trunk_(trunk),
      compartment_(compartment),
      at_(at),
      kept_(kept),
      nuisance_(all_but(kept, trunk.space().size())) {}

/// Goes there in short steps, so that the nuisance stays on one branch: its timing has local optima.
Eigen::VectorXd WithoutNuisance::by_compartment(const Eigen::VectorXd& kept) {
  constexpr double short_step = 0.3;
  const Eigen::VectorXd way = kept - at_(kept_);
  const int steps = std::max(1, static_cast<int>(std::ceil(way.cwiseAbs().maxCoeff() / short_step)));
  Eigen::VectorXd all = at_;
  for (int k = 1; k <= steps; ++k) {
    all(kept_) = at_(kept_) + way * (static_cast<double>(k) / steps);
    all = best_nuisance(compartment_.problem(), all, kept_);
  }
  return all;
}

/// Returns what is left of the columns once the nuisance has explained what it can.
Eigen::MatrixXd WithoutNuisance::without_nuisance(const Eigen::MatrixXd& rows, const Eigen::VectorXd& all) {
  if (nuisance_.empty()) return rows;
  const Slopes slopes = compartment_.slopes(all, nuisance_);
  if (!slopes) return rows;
  return rows - *slopes * (pseudo_inverse(*slopes) * rows);
}

Outcome WithoutNuisance::eliminated(const Eigen::VectorXd& all, const Outcome& outcome) {
  if (!outcome.residuals) return outcome;
  const Eigen::VectorXd left = without_nuisance(*outcome.residuals, all);
  return {left, left.squaredNorm()};
}

LeastSquares WithoutNuisance::problem() {
  const auto outcomes = [this](const std::vector<Eigen::VectorXd>& some) {
    std::vector<Eigen::VectorXd> all;
    for (const Eigen::VectorXd& kept : some) all.push_back(by_compartment(kept));
    std::vector<Outcome> result = trunk_.problem().outcomes(all);
    for (std::size_t i = 0; i < all.size(); ++i) result[i] = eliminated(all[i], result[i]);
    return result;
  };
  const SearchSpace& space = trunk_.space();
  LeastSquares problem{outcomes, space.lower()(kept_), space.upper()(kept_)};
  problem.exact_slopes = [problem](const Eigen::VectorXd& kept) { return jacobian(problem, kept); };
  return problem;
}

Eigen::VectorXd WithoutNuisance::completed(const Eigen::VectorXd& kept) {
  Eigen::VectorXd all = by_compartment(kept);
  const LeastSquares problem = trunk_.problem();
  const Outcome outcome = problem.at(all);
  const Slopes slopes = compartment_.slopes(all, nuisance_);
  if (!outcome.residuals || nuisance_.empty() || !slopes) return all;
  all(nuisance_) -= pseudo_inverse(*slopes) * *outcome.residuals;
  return problem.inside(all);
}

}  // namespace trunk
