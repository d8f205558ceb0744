#pragma once

#include <optional>

#include "expiration/recoil_time.hpp"
#include "verdict/draws.hpp"
#include "verdict/fit_results.hpp"

namespace trunk {

/// What the recoil time may be, and how all else follows it.
struct RecoilEnds {
  RecoilTime recoil;
  Candidate low, high;               // fitted at both ends of its interval; high has the longest time
  std::optional<AlongRecoil> along;  // none if bounds leave it no room
};

/// Fits all else again, by the compartment, at both ends of the interval of the recoil time. The interval is
/// that of the energy law, with what given priors and a muscle that is held say beside it. Without these the
/// activation fits every recoil time, and how it is expected to bend is no evidence. `held` is the coordinate
/// of k_elasticity.
RecoilEnds recoil_ends(const FitProblem& problem, const Estimation& estimation, const MeasuredBreath& breath,
                       Eigen::Index held);

}  // namespace trunk
