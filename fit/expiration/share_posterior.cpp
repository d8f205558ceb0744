#include "expiration/share_posterior.hpp"

#include <gsl/gsl_interp.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace trunk {
namespace {

constexpr int points = 4000;
constexpr double farthest = 7.0;  // deviations of the law

/// Interpolates without overshoot (Steffen 1990).
class Course {
 public:
  explicit Course(const RecoilDeviance& known) : known_(known) {
    if (known.log_recoil_s.empty()) return;
    interpolation_.reset(gsl_interp_alloc(gsl_interp_steffen, known.log_recoil_s.size()));
    gsl_interp_init(interpolation_.get(), known.log_recoil_s.data(), known.deviance.data(),
                    known.log_recoil_s.size());
  }

  double operator()(double log_recoil_s) const {
    if (!interpolation_) return 0.0;
    const double at = std::clamp(log_recoil_s, known_.log_recoil_s.front(), known_.log_recoil_s.back());
    return gsl_interp_eval(interpolation_.get(), known_.log_recoil_s.data(), known_.deviance.data(), at,
                           nullptr);
  }

 private:
  struct Free {
    void operator()(gsl_interp* i) const { gsl_interp_free(i); }
  };
  const RecoilDeviance& known_;
  std::unique_ptr<gsl_interp, Free> interpolation_;
};

/// Returns the variance of a grid under weights.
double variance(const std::vector<double>& at, const std::vector<double>& weight) {
  double sum = 0.0, mean = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) sum += weight[i], mean += weight[i] * at[i];
  mean /= sum;
  for (std::size_t i = 0; i < at.size(); ++i) squares += weight[i] * (at[i] - mean) * (at[i] - mean);
  return squares / sum;
}

}  // namespace

SharePosterior::SharePosterior(const ExpiredEnergy& energy, const RecoilDeviance& beside) {
  const Course course(beside);
  const double lowest =
      beside.deviance.empty() ? 0.0 : *std::min_element(beside.deviance.begin(), beside.deviance.end());
  const double usual = std::log(EnergyLaw::usual_share), first = usual - farthest * EnergyLaw::log_deviation;
  const double step = -first / points;
  std::vector<double> law, density;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double log_share = first + (i + 0.5) * step, z = (log_share - usual) / EnergyLaw::log_deviation;
    law.push_back(std::exp(-0.5 * z * z));
    density.push_back(
        law.back() *
        std::exp(-0.5 * (course(std::log(recoil_time_s(energy, std::exp(log_share)))) - lowest)));
    log_share_.push_back(log_share + 0.5 * step);
    below_.push_back(sum += density.back());
  }
  for (double& part : below_) part /= sum;
  if (beside.deviance.empty()) return;
  const auto top = std::max_element(density.begin(), density.end()) - density.begin();
  mode_ = std::exp(log_share_[static_cast<std::size_t>(top)] - 0.5 * step);
  weight_ = std::min(1.0, variance(log_share_, density) / variance(log_share_, law));
}

ShareLimits SharePosterior::limits95() const {
  ShareLimits best{share_at(0.025), share_at(0.975)};
  constexpr int tries = 200;
  for (int i = 1; i < tries; ++i) {
    const double part = 0.05 * i / tries;
    const ShareLimits some{share_at(part), share_at(part + 0.95)};
    if (some.high / some.low < best.high / best.low) best = some;
  }
  return best;
}

double SharePosterior::share_at(double part) const {
  const auto above = std::upper_bound(below_.begin(), below_.end(), part);
  const auto i = static_cast<std::size_t>(std::min(above, below_.end() - 1) - below_.begin());
  const double before = i == 0 ? 0.0 : below_[i - 1], step = log_share_[1] - log_share_[0];
  const double within = (part - before) / std::max(below_[i] - before, 1e-300);
  return std::exp(log_share_[i] - (1.0 - std::clamp(within, 0.0, 1.0)) * step);
}

}  // namespace trunk
