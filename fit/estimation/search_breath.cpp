#include "estimation/search_breath.hpp"

#include <algorithm>
#include <cmath>

#include "linear_algebra/decompositions.hpp"

namespace trunk {
namespace {

// In coordinates, between two methods. Beside priors the posterior of several observables is flat.
constexpr double close_enough = 2e-3, close_enough_of_several = 0.03;

/// Returns the step of Gauss and Newton within the bounds, with slopes from differences; none if a simulation
/// fails.
std::optional<Eigen::VectorXd> gauss_newton_step(const LeastSquares& problem, const Eigen::VectorXd& from) {
  const double difference = 0.01;
  const Outcome here = problem.at(from);
  const Slopes slopes = jacobian(problem, from, difference);
  if (!here.residuals || !slopes) return std::nullopt;
  return problem.inside(from - pseudo_inverse(*slopes) * *here.residuals) - from;
}

class BreathSearch {
 public:
  BreathSearch(Objective& trunk, Objective& compartment, CompartmentModel& model,
               const Parameters<double>& begin, const EstimationOptions& options, Estimation& e)
      : trunk_(trunk), compartment_(compartment), model_(model), begin_(begin), options_(options), e_(e) {}

  void run() {
    adopt(corrected(trunk_.space().start()));
    if (!e_.search.converged) fall_back();
    if (e_.search.converged && trunk_.blocks().size() > 1) weigh();
    if (e_.search.converged) search_trunk();
    if (options_.loss == Loss::squares || !e_.search.converged) return;
    use_robust_loss();
    adopt(corrected(e_.search.best));
    search_trunk();
  }

 private:
  /// Corrects the compartment by the trunk and searches it again, until the trunk's objective stays as it is.
  /// It fails only if the trunk does: the search that follows does not depend on how near this one came.
  SearchResult corrected(Eigen::VectorXd x) {
    constexpr int most_rounds = 4;
    SearchResult result{false, x, 0.0, "the trunk fails where the compartment is best", 0};
    for (int round = 0; round < most_rounds; ++round) {
      const Outcome here = trunk_.problem().at(x);
      ++result.evaluations;
      if (!here.residuals) break;
      const double before = result.objective;
      if (round == 0 || here.objective < before) {
        result.best = x;
        result.objective = here.objective;
        result.converged = true;
      }
      if (round > 0 && std::abs(here.objective - before) < 1e-3 * before) break;
      model_.correct_at(trunk_.space().decode(x), *trunk_.model(x));
      x = best_nuisance(compartment_.problem(), x, {});
    }
    correct_compartment(result.best);
    return result;
  }

  /// Gives each observable beside the volume the noise that it has (REML), and searches again. A curve counts
  /// as its effective number of independent samples, n (1 - rho) / (1 + rho), at least 10 (our choice: what a
  /// fit does not follow yet looks like noise that is one sample), and its noise as at least 0.5 % of its
  /// range in 20 independent samples (our choice: no model is better).
  void weigh() {
    constexpr int rounds = 2;
    constexpr double least_share = 0.005, independent_samples = 20.0, fewest = 10.0;
    for (int round = 0; round < rounds; ++round) {
      const auto rows = jacobian(compartment_.problem(), e_.search.best);
      const auto values = trunk_.model(e_.search.best);
      if (!rows || !values) return;
      const Eigen::VectorXd residuals = trunk_.whitened(*values - trunk_.measured());
      std::vector<double> deviations;
      for (std::size_t b = 1; b < trunk_.blocks().size(); ++b) {
        const Block& block = trunk_.blocks()[b];
        const double now = trunk_.deviation()[block.first];
        const Noise noise = noise_of_block(trunk_, b, residuals, *rows);
        const auto course = values->segment(block.first, block.count);
        const auto count = static_cast<double>(block.count);
        const double least =
            least_share * (course.maxCoeff() - course.minCoeff()) * std::sqrt(count / independent_samples);
        const double independent = std::max(count * (1.0 - noise.rho) / (1.0 + noise.rho), fewest);
        const double found = now * std::min(noise.deviation * std::sqrt(count / independent),
                                            noise.white_deviation * std::sqrt(count / fewest));
        deviations.push_back(block.count == 1 ? now : std::max(found, least));
      }
      trunk_.reweigh(deviations);
      compartment_.reweigh(deviations);
      adopt(corrected(e_.search.best));
    }
  }

  void correct_compartment(const Eigen::VectorXd& x) {
    if (const auto volumes = trunk_.model(x)) model_.correct_at(trunk_.space().decode(x), *volumes);
  }

  /// Searches the trunk alone, with slopes from differences: its volume does not follow one compartment.
  void fall_back() {
    LeastSquares problem = trunk_.problem();
    problem.exact_slopes = nullptr;
    SearchOptions options = options_.search;
    options.objective_tolerance = std::max(options.objective_tolerance, 1e-5);
    options.max_evaluations *= 1 + static_cast<int>(trunk_.space().size()) / 2;
    adopt(levenberg_marquardt(problem, start_at_tidal_volume(trunk_, trunk_.space().start()), options));
    correct_compartment(e_.search.best);
  }

  /// Searches the mechanical parameters asked for on the trunk; the others move along.
  void search_trunk() {
    const Indices some = mechanical_asked_for(trunk_.space());
    if (some.empty()) return;
    const bool by_default = options_.search.algorithm.empty();
    SearchOptions options = options_.search;
    options.algorithm = e_.algorithm;
    options.coordinate_tolerance = std::max(options.coordinate_tolerance, 1e-4);
    e_.cross_check.reset();
    WithoutNuisance posterior(trunk_, compartment_, e_.search.best, some);
    const LeastSquares problem = posterior.problem();
    Eigen::VectorXd from = (by_default ? e_.search.best : asked_begin())(some);
    if (by_default) {  // the compartment is near, and a Gauss-Newton step gets nearer
      if (const auto step = gauss_newton_step(problem, from)) from += *step;
      options.first_step = 0.005;
    }
    SearchResult found;
    constexpr int most_passes = 3;
    for (int pass = 0; pass < most_passes && !(e_.cross_check && e_.cross_check->agree); ++pass) {
      const int before = found.evaluations;
      found = minimise(problem, pass == 0 ? from : found.best, options);
      found.evaluations += before;
      finish(problem, found.best);
      options.first_step = 0.005;
    }
    found.evaluations += e_.search.evaluations;
    found.best = posterior.completed(found.best);
    found.objective = trunk_.problem().at(found.best).objective;
    settle(some, found);
    e_.search = std::move(found);
    correct_compartment(e_.search.best);
  }

  /// Lets the nuisance settle where the trunk wants it, with the coordinates `kept` as they are. => found
  void settle(const Indices& kept, SearchResult& found) {
    constexpr int most_rounds = 3;
    for (int round = 0; round < most_rounds; ++round) {
      correct_compartment(found.best);
      const Eigen::VectorXd x = best_nuisance(compartment_.problem(), found.best, kept);
      const double objective = trunk_.problem().at(x).objective;
      const bool better = objective < found.objective * (1.0 - 1e-3);
      if (objective < found.objective) {
        found.best = x;
        found.objective = objective;
      }
      if (!better) return;
    }
  }

  /// Returns the stiffness at which a search begins that is asked for by name. All else is the compartment's
  /// best there, so that the search begins at the measured tidal volume.
  Eigen::VectorXd asked_begin() {
    const SearchSpace& space = trunk_.space();
    const auto elasticity = space.find("k_elasticity");
    if (!elasticity) return e_.search.best;
    Eigen::VectorXd begin = e_.search.best;
    const auto held = static_cast<Eigen::Index>(*elasticity);
    begin[held] = std::log(begin_.elasticity);
    return best_nuisance(compartment_.problem(), compartment_.problem().inside(begin), {held});
  }

  /// Compares the end of a search with where a Gauss-Newton step would go from there, and goes there if it is
  /// near. => end, e_.cross_check
  void finish(const LeastSquares& problem, Eigen::VectorXd& end) {
    constexpr double near = 0.05;
    const auto apart = gauss_newton_step(problem, end);
    if (!apart) return;
    const double largest = apart->cwiseAbs().maxCoeff();
    e_.cross_check = {e_.algorithm, "Gauss-Newton", *apart,
                      largest <= (trunk_.blocks().size() > 1 ? close_enough_of_several : close_enough)};
    if (largest < near) end += *apart;
  }

  void use_robust_loss() {
    const Eigen::VectorXd residuals = trunk_.whitened(*trunk_.model(e_.search.best) - trunk_.measured());
    const double scale = std::max(median_deviation(residuals), 1e-9);
    trunk_.use_loss(options_.loss, scale);
    compartment_.use_loss(options_.loss, scale);
  }

  void adopt(SearchResult found) {
    found.evaluations += e_.search.evaluations;
    e_.search = std::move(found);
  }

  Objective &trunk_, &compartment_;
  CompartmentModel& model_;
  const Parameters<double>& begin_;
  const EstimationOptions& options_;
  Estimation& e_;
};

}  // namespace

Indices mechanical_asked_for(const SearchSpace& space) {
  Indices indices;
  for (std::size_t i = 0; i < space.asked_for(); ++i)
    if (space.parameter(i).group == FreeParameter::Group::mechanics)
      indices.push_back(static_cast<Eigen::Index>(i));
  return indices;
}

void search_breath(Objective& trunk, Objective& compartment, CompartmentModel& model,
                   const Parameters<double>& begin, const EstimationOptions& options, Estimation& e) {
  BreathSearch(trunk, compartment, model, begin, options, e).run();
}

Eigen::VectorXd start_at_tidal_volume(Objective& objective, const Eigen::VectorXd& start) {
  const SearchSpace& space = objective.space();
  const auto muscle = space.find("k_muscle");
  const double measured = objective.measured_curve().tidal_volume();
  if (!muscle || measured <= 0.0) return start;
  const auto ratio = static_cast<Eigen::Index>(*muscle);
  const double lowest = space.lower()[ratio], highest = space.upper()[ratio];
  Eigen::VectorXd x = start;
  for (int steps = 0; steps < 8; ++steps) {
    const auto curve = objective.model(x);
    const double model = curve ? curve->head(objective.blocks().front().count).maxCoeff()
                               : 4.0 * measured;  // it failed, so the muscle is far too strong
    if (std::abs(model / measured - 1.0) < 0.02) return x;
    // The volume is about proportional to the ratio.
    x[ratio] = std::clamp(x[ratio] + std::log(measured / std::max(model, 0.02 * measured)), lowest, highest);
  }
  return x;
}

}  // namespace trunk
