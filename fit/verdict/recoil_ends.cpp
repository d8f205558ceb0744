#include "verdict/recoil_ends.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/nuisance.hpp"

namespace trunk {
namespace {

/// Fits at given recoil times, by the compartment as it follows the trunk at the best point.
class Refits {
 public:
  Refits(const FitProblem& problem, const Estimation& estimation, Eigen::Index held)
      : p_(problem),
        best_(problem.space.decode(estimation.local->x)),
        x_(estimation.local->x),
        held_(held),
        model_(problem.compartment, problem.grid, problem.measured),
        posterior_(model_, problem.grid, problem.space, problem.measured, problem.knowledge),
        without_energy_(model_, problem.grid, problem.space, problem.measured) {
    model_.correct_at(best_, estimation.model);
    posterior_.use_correlation(problem.correlation);
    without_energy_.use_correlation(problem.correlation);
  }

  const Candidate& best() const noexcept { return best_; }

  double time_of(const Candidate& c) const { return p_.compartment.recoil_time_s(c.parameters); }

  Candidate at(double recoil_s) {
    Eigen::VectorXd x = x_;
    // A lung alone may spring back faster than that: the bound then stops the coordinate.
    x[held_] = std::log(std::max(p_.compartment.elasticity_of(recoil_s, best_.parameters), 1e-6));
    x = posterior_.problem().inside(x);
    return p_.space.decode(best_nuisance(posterior_.problem(), x, {held_}));
  }

  Candidate halfway_to(const Candidate& end) { return at(std::sqrt(time_of(end) * time_of(best_))); }

  /// Returns -2 log of the likelihood and of the priors, without the energy.
  double deviance_at(const Candidate& c) {
    return without_energy_.problem().at(p_.space.encode(c)).objective;
  }

 private:
  const FitProblem& p_;
  Candidate best_;
  Eigen::VectorXd x_;
  Eigen::Index held_;
  CompartmentModel model_;
  Objective posterior_, without_energy_;
};

/// Returns what is known of the recoil time beside the energy.
RecoilDeviance beside_energy(const SearchSpace& space, Refits& refits) {
  bool given = !space.find("k_muscle");
  for (std::size_t i = 0; i < space.size(); ++i) given |= space.given_deviation(i) > 0.0;
  RecoilDeviance known;
  if (!given) return known;
  const double best = std::log(refits.time_of(refits.best()));
  for (const double away :
       {-2.0, -1.3, -0.8, -0.4, -0.2, -0.1, -0.05, 0.0, 0.05, 0.1, 0.2, 0.4, 0.8, 1.3, 2.0}) {
    const Candidate there = refits.at(std::exp(best + away));
    const double log_time = std::log(refits.time_of(there));
    if (!known.log_recoil_s.empty() && log_time <= known.log_recoil_s.back() + 1e-3) continue;  // at a bound
    known.log_recoil_s.push_back(log_time);
    known.deviance.push_back(refits.deviance_at(there));
  }
  return known.log_recoil_s.size() < 3 ? RecoilDeviance{} : known;
}

}  // namespace

RecoilEnds recoil_ends(const FitProblem& problem, const Estimation& estimation, const MeasuredBreath& breath,
                       Eigen::Index held) {
  Refits refits(problem, estimation, held);
  const RecoilDeviance beside = beside_energy(problem.space, refits);
  RecoilEnds ends{recoil_time(breath, beside), {}, {}, std::nullopt};
  const double longest_s =
      std::isfinite(ends.recoil.upper95_s) ? ends.recoil.upper95_s : 3.0 * ends.recoil.lower95_s;
  ends.low = refits.at(ends.recoil.lower95_s);
  ends.high = refits.at(longest_s);
  const ExpiredEnergy energy = expired_energy(breath);
  AlongRecoil along{energy,
                    SharePosterior(energy, beside),
                    ends.recoil.log_error,
                    std::max(1.0, breath.breaths_used - 1.0),
                    {}};
  for (const Candidate& c :
       {ends.low, refits.halfway_to(ends.low), refits.best(), refits.halfway_to(ends.high), ends.high}) {
    const double log_time = std::log(refits.time_of(c));
    if (along.refits.empty() || log_time > along.refits.back().first + 0.01)
      along.refits.emplace_back(log_time, problem.space.encode(c));
  }
  if (along.refits.size() >= 2) ends.along = std::move(along);
  return ends;
}

}  // namespace trunk
