#include "problem/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "errors/input_error.hpp"

namespace trunk {

Eigen::VectorXd sampled(const std::vector<double>& curve, double dt_s, const std::vector<double>& time_s) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(time_s.size()));
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double at = std::clamp(time_s[i] / dt_s, 0.0, static_cast<double>(curve.size() - 1));
    const auto before = std::min(static_cast<std::size_t>(at), curve.size() - 2);
    const double part = at - static_cast<double>(before);
    values[static_cast<Eigen::Index>(i)] = curve[before] + part * (curve[before + 1] - curve[before]);
  }
  return values;
}

Eigen::VectorXd as_target_sees(const Target& target, const std::vector<double>& curve, double dt_s) {
  if (target.is_tidal_volume())
    return Eigen::VectorXd::Constant(1, *std::max_element(curve.begin(), curve.end()));
  return sampled(curve, dt_s, target.time_s);
}

Objective::Objective(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space, const Target& target)
    : trunk_(trunk), grid_(grid), space_(space), target_(target) {
  if (!target.is_tidal_volume() && (target.time_s.empty() || target.time_s.size() != target.delta_v.size()))
    throw InputError("the measured curve has no samples");
  if (!target.time_s.empty() && target.time_s.back() > grid.duration_s + grid.dt_s)
    throw InputError(
        fmt::format("the measured curve lasts {:.3f} s, the simulation {:.3f} s; expected the "
                    "simulation to cover it",
                    target.time_s.back(), grid.duration_s));
  for (double v : target.delta_v) target_energy_ += v * v;
}

std::optional<Eigen::VectorXd> Objective::residuals_of(const VolumeCurve& curve) const {
  if (!curve.summary.completed()) return std::nullopt;
  const Eigen::VectorXd measured =
      Eigen::VectorXd::Map(target_.delta_v.data(), static_cast<Eigen::Index>(target_.delta_v.size()));
  return as_target_sees(target_, curve.delta_v, grid_.dt_s) - measured;
}

std::optional<Eigen::VectorXd> Objective::residuals_of(const Candidate& candidate) const {
  return residuals_of(simulate_volume(trunk_, candidate.parameters, candidate.activation, grid_));
}

Objective::Outcome Objective::evaluate(const Eigen::VectorXd& x) {
  const Candidate candidate = space_.decode(x);
  const auto start = std::chrono::steady_clock::now();
  const VolumeCurve curve = simulate_volume(trunk_, candidate.parameters, candidate.activation, grid_);
  Outcome outcome{residuals_of(curve), 0.0};
  if (outcome.residuals) outcome.objective = outcome.residuals->squaredNorm();
  if (!outcome.residuals || !finite(outcome.objective)) {
    const double lasted = curve.summary.time_s / grid_.duration_s;
    outcome = {std::nullopt, 100.0 * target_energy_ * (2.0 - std::clamp(lasted, 0.0, 1.0))};
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  evaluations_.push_back({x, outcome.objective, curve.summary.status, wall.count()});
  return outcome;
}

std::optional<Eigen::VectorXd> Objective::residuals(const Eigen::VectorXd& x) {
  return evaluate(x).residuals;
}

double Objective::operator()(const Eigen::VectorXd& x) {
  return evaluate(x).objective;
}

int Objective::failures() const noexcept {
  return static_cast<int>(std::count_if(evaluations_.begin(), evaluations_.end(), [](const Evaluation& e) {
    return e.status != Summary::Status::completed;
  }));
}

const Evaluation* Objective::best() const noexcept {
  const Evaluation* best = nullptr;
  for (const Evaluation& e : evaluations_)
    if (e.status == Summary::Status::completed && (!best || e.objective < best->objective)) best = &e;
  return best;
}

}  // namespace trunk
