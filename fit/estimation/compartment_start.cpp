#include "estimation/compartment_start.hpp"

#include <algorithm>
#include <cmath>

#include "search/minimise.hpp"
#include "search/multistart.hpp"

namespace trunk {
namespace {

constexpr double rough = 1e-3,
                 fine = 1e-7;            // tolerances of the objective: to compare optima, and of the best
constexpr double usual_recoil_s = 0.35;  // our choice: where a search for it begins

/// Returns how far starts are spread on either side of the first one, in coordinates (our choice).
double spread_of(const FreeParameter& p) {
  if (p.name == "k_elasticity" || p.name == "damping") return std::log(4.0);
  if (p.name == "onset") return 1.5;  // 0.15 s
  if (p.name == "rise") return std::log(1.5);
  if (p.name == "fast_fall" || p.name == "slow_fall") return std::log(4.0);
  if (p.name == "fast_fall_level") return std::log(2.0);
  return 0.0;
}

/// Changes the ratio of k_muscle to k_elasticity until the compartment has the measured tidal volume.
void meet_tidal_volume(Objective& compartment, Eigen::VectorXd& x) {
  const auto muscle = compartment.space().find("k_muscle");
  const auto curve = compartment.model(x);
  const double highest = curve ? curve->head(compartment.blocks().front().count).maxCoeff() : 0.0;
  if (!muscle || !(highest > 0.0)) return;
  x[static_cast<Eigen::Index>(*muscle)] += std::log(compartment.measured_curve().tidal_volume() / highest);
  x = compartment.problem().inside(x);
}

std::vector<Eigen::VectorXd> starts_of(Objective& compartment, const Indices& free, int count, unsigned seed,
                                       bool airway_drives) {
  const SearchSpace& space = compartment.space();
  const Eigen::VectorXd first = space.start();
  Eigen::VectorXd low = first, high = first;
  for (const Eigen::Index i : free) {
    const double spread = spread_of(space.parameter(static_cast<std::size_t>(i)));
    low[i] -= spread;
    high[i] += spread;
  }
  const LeastSquares box{{}, low.cwiseMax(space.lower()), high.cwiseMin(space.upper())};
  std::vector<Eigen::VectorXd> all =
      sobol_starts(box, static_cast<std::size_t>(std::max(count - 1, 0)), seed);
  all.insert(all.begin(), first);
  if (!airway_drives) {
    for (Eigen::VectorXd& x : all) meet_tidal_volume(compartment, x);
    return all;
  }
  // The airway gives a part of the volume, or all of it: starts go from hardly any muscle to the usual one.
  if (const auto muscle = space.find("k_muscle"))
    for (std::size_t k = 0; k < all.size(); ++k) {
      auto& ratio = all[k][static_cast<Eigen::Index>(*muscle)];
      ratio -= std::log(100.0) * static_cast<double>(k % 3) / 2.0;
      all[k] = compartment.problem().inside(all[k]);
    }
  return all;
}

/// Returns the candidate with the k_elasticity at which searches begin.
Candidate with_recoil(Candidate begin, const CompartmentFit& fit) {
  const FreeParameter& p = free_parameter("k_elasticity");
  const double recoil_s = fit.recoil_s.value_or(usual_recoil_s);
  const double before = begin.parameters.elasticity;
  begin.parameters.elasticity =
      std::clamp(fit.compartment.elasticity_of(recoil_s, begin.parameters), p.lower, p.upper);
  if (std::count(fit.names.begin(), fit.names.end(), "k_muscle") > 0)  // else it is held
    begin.parameters.muscle *= begin.parameters.elasticity / before;
  return begin;
}

}  // namespace

std::vector<Prior> priors_of_straight_lines(std::vector<Prior> priors,
                                            const std::vector<std::string>& beside) {
  for (const std::string& name : beside)
    if (std::none_of(priors.begin(), priors.end(), [&](const Prior& p) { return p.name == name; }))
      priors.push_back({name, {}, 0.0});
  return priors;
}

std::vector<LocalSearch> compartment_searches(const CompartmentFit& fit, const Candidate& begin) {
  const bool recoils = std::count(fit.names.begin(), fit.names.end(), "k_elasticity") > 0;
  const SearchSpace space(
      fit.names, recoils && (fit.recoil_s || fit.begin_at_usual_recoil) ? with_recoil(begin, fit) : begin,
      fit.beside, fit.priors);
  CompartmentModel model(fit.compartment, fit.grid, fit.measured);
  Objective objective(model, fit.grid, space, fit.measured, fit.knowledge);
  objective.use_correlation(fit.correlation);
  const LeastSquares problem = objective.problem();
  Indices held;
  if (recoils && fit.recoil_s) held.push_back(static_cast<Eigen::Index>(*space.find("k_elasticity")));
  const Indices free = all_but(held, space.size());
  const auto searched = [&](const Eigen::VectorXd& start, double tolerance) {
    SearchOptions options;
    options.objective_tolerance = tolerance;
    options.max_evaluations = 150;
    const LeastSquares part = with_fixed(problem, start, free);
    SearchResult found = levenberg_marquardt(part, start(free), options);
    Eigen::VectorXd to = start;
    to(free) = found.best;
    found.best = to;
    return found;
  };
  std::vector<LocalSearch> searches;
  std::vector<Eigen::VectorXd> ends;
  for (const Eigen::VectorXd& start :
       starts_of(objective, free, fit.starts, fit.seed, fit.compartment.airway_drives())) {
    SearchResult found{true, start, problem.at(start).objective, "", 1};
    if (!free.empty()) found = searched(start, rough);
    searches.push_back({space.decode(start), space.decode(found.best), found.objective, found.converged});
    ends.push_back(found.best);
  }
  const auto better = [](const LocalSearch& a, const LocalSearch& b) { return a.objective < b.objective; };
  const auto best = std::min_element(searches.begin(), searches.end(), better);
  if (!free.empty()) {
    const SearchResult found = searched(ends[static_cast<std::size_t>(best - searches.begin())], fine);
    best->to = space.decode(found.best);
    best->objective = std::min(found.objective, best->objective);
  }
  std::stable_sort(searches.begin(), searches.end(), better);
  return searches;
}

}  // namespace trunk
