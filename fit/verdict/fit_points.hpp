#pragma once

#include <optional>

#include "anatomy/breath_run.hpp"
#include "verdict/assess_fit.hpp"
#include "verdict/recoil_ends.hpp"
#include "verdict/spread.hpp"

namespace trunk {

/// A reading at the best point and at both ends of the interval of the recoil time, and its statistical
/// deviation there.
struct Readings {
  double best = std::numeric_limits<double>::quiet_NaN(), low_recoil = best, high_recoil = best;
  double deviation = 0.0;  // of the logarithm if `factor`
  bool factor = true;      // the number is positive and its interval is a factor
  std::vector<Share> shares{};
};

/// The points of a converged fit from which its results are read: the best one, and those at both ends of the
/// interval of the recoil time. The evidence must outlive them.
class FitPoints {
 public:
  /// Fits all else again at both ends of the recoil time, if the energy law is a part of the posterior.
  explicit FitPoints(const FitEvidence& evidence);

  const FitEvidence& evidence() const noexcept { return in_; }
  const Candidate& best() const noexcept { return best_; }
  const Candidate& low_recoil() const noexcept { return low_; }
  const Candidate& high_recoil() const noexcept { return high_; }
  /// Returns what the energy of expiration gives; none if it is not known.
  const std::optional<RecoilTime>& recoil() const noexcept { return recoil_; }
  double quantile() const noexcept { return quantile_; }
  Posterior posterior() const;

  Readings read(const Reading& reading, bool factor = true) const;
  /// Returns the deviation of a reading at the best point.
  double deviation(const Reading& reading) const;

  /// Relative deviation of the measured volume: 1 % for segmentation and compartment, and that of a gain that
  /// differs with the direction of flow. The 1 % is our choice: without it the ratio of twins whose breaths
  /// are equal was covered in 58 to 83 % of 12 recordings, and its median was up to 0.7 % off.
  double volume_error() const;

  /// Returns the interval: the spread of breaths and noise, and what the recoil time changes, as the root of
  /// the sum of squares. `gain` adds the error of the volume's gain.
  FitResult result(const char* name, const char* unit, const Readings& readings, bool gain) const;

  /// Returns the same of a number that the muscle makes. A breath that an airway drives may have no muscle at
  /// all: 0 is in the interval then.
  FitResult muscular(const char* name, const char* unit, const Reading& reading) const;

  /// Grades a result after what it rests on where forces count, and else after a reason against it, if there
  /// is one.
  void grade(FitResult& result, const std::string& reason) const;

 private:
  const FitEvidence& in_;
  Candidate best_, low_, high_;  // high_ has the longest recoil time
  std::optional<RecoilTime> recoil_;
  std::optional<AlongRecoil> along_;
  Eigen::MatrixXd covariance_;
  double quantile_ = 0.0;
};

/// The 97.5 % point of the normal distribution.
inline constexpr double normal_quantile = 1.96;

}  // namespace trunk
