#include "verdict/reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace trunk {
namespace {

/// Returns the first parameter that stopped at its bound, or "".
std::string at_bound(const FitEvidence& in) {
  for (const std::vector<Estimate>* list :
       {&in.estimation.uncertainty->parameters, &in.estimation.uncertainty->beside})
    for (const Estimate& estimate : *list)
      if (estimate.at_bound && !estimate.name.starts_with("shape_")) return estimate.name;
  return "";
}

/// Other optima that fit as well, at another recoil time.
std::string two_optima(const FitEvidence& in) {
  for (const LocalSearch& s : in.optima) {
    const double first = in.problem.compartment.recoil_time_s(in.optima.front().to.parameters),
                 other = in.problem.compartment.recoil_time_s(s.to.parameters);
    if (s.objective <= 1.05 * in.optima.front().objective && std::abs(std::log(other / first)) > 0.2)
      return fmt::format("recoil times of {:.2g} s and {:.2g} s fit equally well", first, other);
  }
  return "";
}

std::string energy_reason(const FitEvidence& in) {
  if (!in.breath || !in.problem.space.find("k_elasticity")) return "";
  const double share = resistive_share(expired_energy(*in.breath),
                                       in.problem.compartment.recoil_time_s(in.estimation.best.parameters));
  if (share >= share_limits95().low && share <= 1.0) return "";
  return fmt::format(
      "it lets the airway take {:.0f} % of the energy that recoil stores; 18 to 100 % is plausible",
      100.0 * share);
}

std::string assumption_on_course(const FitEvidence& in) {
  if (in.straight) return "the activation is made of straight lines";
  if (in.energy_known) return "the airway takes about 40 % (18 to 87 %) of the energy that recoil stores";
  return in.problem.space.find("k_elasticity") ? "the course of the activation is as given"
                                               : "k_elasticity is as given";
}

/// Returns "; the prior given for k_elasticity holds", or "" if none was given.
std::string given_priors(const FitEvidence& in) {
  std::string names;
  for (std::size_t i = 0; i < in.problem.space.asked_for(); ++i)
    if (in.problem.space.given_deviation(i) > 0.0)
      names += (names.empty() ? "" : " and ") + std::string(in.problem.space.parameter(i).name);
  return names.empty() ? "" : "; the prior given for " + names + " holds";
}

}  // namespace

std::string course_assumption(const FitEvidence& in) {
  return assumption_on_course(in) + given_priors(in);
}

std::string few_breaths(const FitEvidence& in) {
  const int used = in.breath ? in.breath->breaths_used : 0;
  if (used >= 3) return "";
  return used == 1 ? "one breath shows no spread" : fmt::format("{} breaths show too little spread", used);
}

std::string course_reason(const FitEvidence& in, const std::optional<RecoilTime>& recoil) {
  if (std::string few = few_breaths(in); !few.empty()) return few;
  if (in.energy_known && recoil && !recoil->has_upper_limit)
    return "expiration does not slow down before it ends, so no recoil time is too long";
  if (const std::string bound = at_bound(in); !bound.empty()) return bound + " stopped at its bound";
  if (in.energy_known) return "";
  if (std::string two = two_optima(in); !two.empty()) return two;
  return energy_reason(in);
}

void grade_inspiration(const FitEvidence& in, FitResult& r) {
  const std::string few = few_breaths(in);
  if (!few.empty()) return set_reason(r, few);
  const double half_width = std::max(r.upper95 / r.value, r.value / r.lower95) - 1.0;
  const RecoilTime recoil = in.breath ? recoil_time(*in.breath) : RecoilTime{};
  const bool rests = recoil.late_share < 0.1;
  if (rests && in.breath && in.breath->breaths_used >= 5 && half_width <= 0.10)
    r.grade = Grade::determined;
  else
    r.assumption = rests ? "more breaths would be like these"
                         : "the recoil time is as given below, since expiration does not end at rest";
}

namespace {

/// Returns what holds if a prior does.
std::string assumption_behind(const std::string& source) {
  if (source == "shape") return "the activation has a usual shape";
  if (source == "timing") return "the timing is as the scenario and the trace suggest";
  if (source == "energy of expiration")
    return "the airway takes about 40 % (18 to 87 %) of the energy that recoil stores";
  return "the " + source + " holds";
}

/// Returns whether a share is that of a usual prior, which the user has not replaced.
bool is_usual_prior(const FitEvidence& in, const Share& share) {
  return std::any_of(in.scale.begin(), in.scale.end(), [&](const ScalePrior& p) {
    return p.source != given_source && share.source == "prior of " + p.name;
  });
}

}  // namespace

bool pressure_measured(const FitEvidence& in) {
  const auto& beside = in.problem.measured.beside;
  return in.airway_driven ||
         std::any_of(beside.begin(), beside.end(), std::mem_fn(&MeasuredObservable::is_pressure));
}

std::string grade_of_shares(const FitEvidence& in, const FitResult& r) {
  constexpr double most_of_priors = 0.1, worth_a_word = 0.05, widest = 0.25, far = 3.0;
  const double size = std::abs(r.value);
  const bool narrow = r.upper95 - r.value <= widest * size && r.value - r.lower95 <= widest * size;
  const bool alone = prior_part(r.shares) <= most_of_priors;
  if (alone && narrow && !in.straight && in.breath && in.breath->breaths_used >= 5) return "";
  std::string text = in.straight ? "the activation is made of straight lines" : "";
  bool usual = false;
  for (const Share& s : r.shares) {
    if (s.measured || s.part < worth_a_word) continue;
    if (is_usual_prior(in, s) && s.pull <= far) {
      if (!std::exchange(usual, true))
        text +=
            std::string(text.empty() ? "" : "; ") + "lung, airway, abdomen and tissue are as usual in adults";
      continue;
    }
    text += (text.empty() ? "" : "; ") + assumption_behind(s.source);
    if (s.pull > far)
      text += fmt::format(", which this recording contradicts: it lies {:.1f} deviations away", s.pull);
  }
  return text.empty() ? "more breaths would be like these" : text;
}

std::string scale_reason(const FitEvidence& in) {
  if (std::string few = few_breaths(in); !few.empty()) return few;
  if (in.airway_driven) return "";  // a breath without a muscle has no timing
  const std::string bound = at_bound(in);
  return bound.empty() ? "" : bound + " stopped at its bound";
}

void set_reason(FitResult& r, const std::string& reason) {
  if (reason.empty()) return;
  r.grade = Grade::not_determined;
  r.reason = reason;
}

}  // namespace trunk
