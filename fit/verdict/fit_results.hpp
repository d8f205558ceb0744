#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "estimation/estimate.hpp"
#include "expiration/recoil_time.hpp"
#include "gates/gates.hpp"
#include "verdict/draws.hpp"
#include "verdict/shares.hpp"

namespace trunk {

/// How far a result can be trusted, from best to worst.
///  - determined: the recording alone determines it to within the interval.
///  - assumption: the interval holds if the assumption that stands beside it holds.
///  - not_determined: the recording does not determine it, for the reason that stands beside it.
///  - not_converged: the search did not end, so there is no result.
enum class Grade { determined, assumption, not_determined, not_converged };

/// Returns "determined", "assumption", "not_determined" or "not_converged".
std::string_view name_of(Grade grade);

/// A number that a fit reports, with its 95 % interval.
struct FitResult {
  std::string name, unit;
  double value = 0.0, lower95 = 0.0, upper95 = 0.0;  // NaN: withheld; infinite: no limit
  Grade grade = Grade::not_determined;
  std::string assumption{};     // what the interval stands on; or ""
  std::string reason{};         // why it is not determined; or ""
  std::string meaning{};        // one line for a physiologist
  std::vector<Share> shares{};  // what it rests on, where forces count; see shares_of
};

/// What the paper's own assumption gives: an activation of straight lines. Its difference from the results
/// shows what the assumption is worth.
struct StraightActivation {
  std::vector<FitResult> results;  // recoil time, ratio, k_elasticity, k_muscle
  double nrmse = 0.0;              // of the one-compartment stand-in
};

/// What a fit says first.
struct FitResults {
  Grade grade = Grade::not_converged;  // the worst of the headline results
  std::vector<Gate> gates;
  std::vector<FitResult> results;
  std::vector<std::string> headline;  // names of results, at most eight
  std::optional<StraightActivation> straight;
  std::string verdict;                 // one to three sentences
  std::optional<Posterior> posterior;  // none if the search did not converge, or one number was measured

  const FitResult* find(std::string_view name) const;
};

}  // namespace trunk
