#include "verdict/fit_points.hpp"

#include <algorithm>
#include <cmath>

#include "verdict/reasons.hpp"
#include "verdict/sentences.hpp"

namespace trunk {

FitPoints::FitPoints(const FitEvidence& evidence) : in_(evidence) {
  const FitProblem& p = in_.problem;
  const Estimation& e = in_.estimation;
  best_ = p.space.decode(e.local->x);
  low_ = high_ = best_;
  covariance_ = e.local->covariance;
  quantile_ = t_quantile(e.local->freedom);
  const auto elasticity = p.space.find("k_elasticity");
  if (!in_.energy_known || !elasticity) return;
  const auto held = static_cast<Eigen::Index>(*elasticity);
  RecoilEnds ends = recoil_ends(p, e, *in_.breath, held);
  covariance_ = covariance_with_held(*e.local, held);
  recoil_ = ends.recoil;
  low_ = ends.low;
  high_ = ends.high;
  along_ = std::move(ends.along);
}

Posterior FitPoints::posterior() const {
  const LocalFit& local = *in_.estimation.local;
  return {local.x, covariance_, local.freedom, volume_error(), along_};
}

Readings FitPoints::read(const Reading& reading, bool factor) const {
  Readings r{reading(best_), reading(low_), reading(high_), 0.0, factor, {}};
  const Reading scaled = [&](const Candidate& c) { return factor ? std::log(reading(c)) : reading(c); };
  const LocalFit& local = *in_.estimation.local;
  const Eigen::VectorXd gradient = gradient_of(scaled, in_.problem.space, local.x);
  r.deviation = deviation_of(gradient, covariance_);
  if (!in_.scale.empty()) r.shares = shares_of(in_.problem, local, gradient);
  return r;
}

double FitPoints::deviation(const Reading& reading) const {
  return deviation_of(gradient_of(reading, in_.problem.space, in_.estimation.local->x), covariance_);
}

double FitPoints::volume_error() const {
  return std::hypot(0.01, in_.gain_error);
}

FitResult FitPoints::result(const char* name, const char* unit, const Readings& r, bool gain) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  FitResult out{name, unit, r.best, unknown, unknown, Grade::assumption};
  const double error = gain ? volume_error() * (r.factor ? 1.0 : std::abs(r.best)) : 0.0;
  const double spread = std::hypot(quantile_ * r.deviation, normal_quantile * error);
  const auto of = [&](double v) { return r.factor ? std::log(v) : v; };
  const auto back = [&](double v) { return r.factor ? std::exp(v) : v; };
  const double below = of(r.best) - std::min({of(r.best), of(r.low_recoil), of(r.high_recoil)});
  const double above = std::max({of(r.best), of(r.low_recoil), of(r.high_recoil)}) - of(r.best);
  out.lower95 = back(of(r.best) - std::hypot(spread, below));
  out.upper95 = back(of(r.best) + std::hypot(spread, above));
  out.meaning = meaning_of(name);
  out.shares = r.shares;
  return out;
}

FitResult FitPoints::muscular(const char* name, const char* unit, const Reading& reading) const {
  if (!in_.airway_driven) return result(name, unit, read(reading), true);
  FitResult r = result(name, unit, read(reading, false), true);
  r.lower95 = std::max(r.lower95, 0.0);
  return r;
}

void FitPoints::grade(FitResult& r, const std::string& reason) const {
  if (in_.scale.empty()) return set_reason(r, reason);
  r.grade = Grade::assumption;
  r.assumption = grade_of_shares(in_, r);
  if (r.assumption.empty()) r.grade = Grade::determined;
  set_reason(r, scale_reason(in_));
}

}  // namespace trunk
