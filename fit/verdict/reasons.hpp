#pragma once

#include <optional>

#include "verdict/assess_fit.hpp"

namespace trunk {

/// Returns what intervals that go with the recoil time stand on.
std::string course_assumption(const FitEvidence& evidence);

/// Returns why the few breaths of a recording show too little spread; "" for three or more.
std::string few_breaths(const FitEvidence& evidence);

/// Returns why nothing that goes with the recoil time is determined; "" if nothing speaks against it.
/// `recoil` is what the energy of expiration gives, if it is known.
std::string course_reason(const FitEvidence& evidence, const std::optional<RecoilTime>& recoil);

/// Grades the muscle against the recoil. It is determined if the end of expiration is at rest, and five
/// breaths or more give it within 10 % (our choice).
void grade_inspiration(const FitEvidence& evidence, FitResult& result);

/// Returns whether a pressure was measured, so that forces have a scale.
bool pressure_measured(const FitEvidence& evidence);

/// Returns what the interval of a result stands on where forces count: the priors and the assumptions that
/// have 5 % or more of its information. It is "" if they have 10 % or less together, the breaths are five or
/// more, no straight lines are assumed, and the interval is within a quarter: the recording alone determines
/// the result then (our choice).
std::string grade_of_shares(const FitEvidence& evidence, const FitResult& result);

/// Returns why nothing is determined where forces count; "" if nothing speaks against it.
std::string scale_reason(const FitEvidence& evidence);

/// Makes a result not determined, for a reason; "" leaves it as it is.
void set_reason(FitResult& result, const std::string& reason);

}  // namespace trunk
