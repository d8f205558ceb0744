#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "expiration/share_posterior.hpp"
#include "problem/search_space.hpp"

namespace trunk {

/// Where all else goes as the recoil time changes. The recoil time itself is drawn from the energy law.
struct AlongRecoil {
  ExpiredEnergy energy;
  SharePosterior share;                                    // of the airway
  double log_error = 0.0;                                  // of ln tau, by the spread of the breaths
  double freedom = 1.0;                                    // degrees of freedom of that error
  std::vector<std::pair<double, Eigen::VectorXd>> refits;  // (ln tau, coordinates), shortest first; 2 or more
};

/// What a fit knows of its candidate.
struct Posterior {
  Eigen::VectorXd x;           // coordinates of the best point
  Eigen::MatrixXd covariance;  // of x; with `along`, at a given recoil time
  double freedom = 0.0;        // degrees of freedom of the covariance
  double volume_error = 0.0;   // relative deviation of the measured volume's gain
  std::optional<AlongRecoil> along{};
};

/// Returns `count` candidates as the posterior has them, within the bounds of the space.
///
/// The spread of breaths and noise is Student's t about the best point. If the energy law is known, the
/// recoil time is drawn from it and from all else that is known (see SharePosterior), and ln tau has the
/// errors of the breaths and of the compartment on top. All else then follows the refits by straight lines in
/// the coordinates over ln tau. A tenth of their span beyond the outer refits is as far as a draw goes (our
/// choice; an infinite recoil time ends there). The numbers are a shifted Sobol sequence (our choice: its
/// percentiles are smoother than those of random numbers). `settle` gets the coordinates of each draw and
/// gives those to take (see Settling); empty: they stay.
std::vector<Candidate> posterior_draws(
    const Posterior& posterior, const SearchSpace& space, std::size_t count, unsigned seed,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& settle = {});

}  // namespace trunk
