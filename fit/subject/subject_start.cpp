// Where the search of a fit begins: the time step, and one compartment that follows the trunk.

#include <algorithm>
#include <cmath>

#include "dynamics/recoil.hpp"
#include "dynamics/stability.hpp"
#include "expiration/recoil_time.hpp"
#include "scenarios/build_trunk.hpp"
#include "subject/subject_fit.hpp"
#include "verdict/straight_activation.hpp"

namespace trunk {
namespace {

constexpr double stiffer_wall = 1.4;       // where the effect of the wall is measured
constexpr double usual_rate_per_s = 50.0;  // k_elasticity / damping: a recoil time of half a second

/// Returns the recoil time at which the compartment begins. Where the energy gives no recoil time, it is
/// long.
double usable_recoil_s(const RecoilTime& recoil) {
  const double longest_s = 3.0;
  return std::isfinite(recoil.median_s) ? std::min(recoil.median_s, longest_s) : longest_s;
}

bool is_shape(const std::string& name) {
  return free_parameter(name).group == FreeParameter::Group::shape;
}

}  // namespace

/// Takes steps of 4 ms with centred damping, unless an option sets the step or the scenario leaves it to the
/// program. Against 1 ms this moves k_elasticity, k_muscle and the recoil time by up to 0.3 %, the
/// ratio, R_EI and the domes by less than 0.1 % (three recordings), in a quarter of the time. Where such a
/// step is not calm or not half of the stable one, it is shorter.
void SubjectFit::choose_step() {
  Scenario& s = file_.scenario;
  if (s.automatic_step) return choose_time_step(file_, trunk_, stiffer_in_searches);
  if (file_.settings.contains("time.dt_ms") || !measurement_.breath) return;
  constexpr double longest_s = 4e-3, calm = 0.8;
  Parameters<double> stiff = s.parameters;
  stiff.elasticity *= stiffer_in_searches;
  stiff.muscle *= stiffer_in_searches;
  double rate = 0.0;
  for (std::size_t i = 0; i < trunk_.model.particles(); ++i)
    rate = std::max(rate, s.parameters.damping * trunk_.model.damping_weight[i] / trunk_.model.mass[i]);
  const bool centred = longest_s * rate <= calm;
  s.time.damping = centred ? Damping::centred : Damping::implicit;
  const double bound_s = stable_time_step(trunk_.model, stiff, s.time.damping);
  const double step_s = std::min({longest_s * (centred ? 1.0 : 0.5), 0.5 * bound_s});
  s.time.dt_s = s.time.duration_s / std::ceil(s.time.duration_s / step_s);
}

/// Lets one compartment find where the search begins. => the scenario's parameters and activation
void SubjectFit::begin_with_compartment(const FitDraft& draft) {
  Scenario& scenario = file_.scenario;
  const Candidate begin{scenario.parameters, scenario.activation};
  // At a stiffness that no start can move: inertia counts a little, and would move the result with the start.
  Parameters<double> usual = scenario.parameters;
  usual.elasticity = usual_rate_per_s * usual.damping;
  const Recoil recoil = measure_recoil(trunk_.model, usual);
  compartment_ = as_compartment(recoil, trunk_.model.pleura);
  if (!scale_.empty()) {
    usual.abdomen_factor = stiffer_wall * scenario.parameters.abdomen_factor;
    compartment_.wall = wall_factor(recoil, measure_recoil(trunk_.model, usual));
  }
  // At first the volume alone is searched: the compartment has no pressures yet.
  const MeasuredCurve volume{measured_curve_.time_s, measured_curve_.delta_v, measured_curve_.sigma_m3, {}};
  CompartmentFit fit{compartment_, scenario.time, volume, draft.names, draft.beside, plan_.priors};
  fit.starts = plan_.starts;
  fit.seed = plan_.estimation.search.seed;
  const bool shaped = std::any_of(draft.beside.begin(), draft.beside.end(), is_shape) ||
                      std::any_of(draft.names.begin(), draft.names.end(), is_shape);
  if (draft.has("k_elasticity")) knowledge_ = knowledge_of(shaped);
  fit.knowledge = knowledge_;
  if (shaped && draft.has("k_elasticity") && !driven_by_airway()) {
    fit.recoil_s = usable_recoil_s(recoil_time(*measurement_.breath));
    straight_ = straight_activation(fit, begin, measurement_.breath->each_m3);
  }
  if (!scale_.empty()) {  // priors and pressures tell k_elasticity as much as the recoil time does
    fit.recoil_s.reset();
    fit.begin_at_usual_recoil = false;
  }
  if (plan_.straight) {
    const auto& breath = *measurement_.breath;
    correlation_ = noise_correlation(
        Eigen::VectorXd::Map(breath.volume_m3.data(), static_cast<Eigen::Index>(breath.volume_m3.size())),
        breath.each_m3);
    fit.correlation = correlation_;
  }
  if (plan_.timing == Timing::trace)
    for (const std::string& name : timing_names()) fit.beside.push_back(name);
  if (fit.beside.empty()) fit.starts = 1;
  searches_ = trunk::compartment_searches(fit, begin);
  scenario.parameters = searches_.front().to.parameters;
  scenario.activation = searches_.front().to.activation;
}

/// Makes the compartment follow the trunk over this breath as well as one compartment can.
/// => compartment_, k_muscle
void SubjectFit::calibrate_compartment(const FitDraft& draft) {
  Scenario& scenario = file_.scenario;
  Parameters<double>& p = scenario.parameters;
  const Candidate begin{p, scenario.activation};
  const VolumeCurve curve = simulate_volume(trunk_, p, scenario.activation, scenario.time);
  if (!curve.ending.completed()) return;
  if (!measured_curve_.beside.empty()) calibrate(begin, curve, scenario.time, compartment_);
  if (driven_by_airway()) return;  // a breath that no muscle drives shows no gain
  const Eigen::VectorXd seen = sampled(curve.delta_v, scenario.time.dt_s, measured_curve_.time_s);
  const MeasuredCurve breath{measured_curve_.time_s, {seen.data(), seen.data() + seen.size()}, {}, {}};
  // A timing that is fitted takes up a part of what the compartment misses, so it moves here too.
  CompartmentFit fit{compartment_, scenario.time, breath, {"k_elasticity", "k_muscle"}, draft.timing(), {}};
  fit.starts = 1;
  fit.begin_at_usual_recoil = false;
  const Parameters<double> found = trunk::compartment_searches(fit, begin).front().to.parameters;
  const TrunkAsCompartment moved = compartment_.moved(found, p);
  const double recoil = moved.recoil, gain = moved.gain_m3;
  // Where the trunk does not breathe like one compartment, what was measured at rest serves better.
  if (!(std::abs(std::log(recoil / compartment_.recoil)) <= 0.3)) return;
  const auto within = [](const char* name, double value) {
    return std::clamp(value, free_parameter(name).lower, free_parameter(name).upper);
  };
  const double ratio = p.muscle / p.elasticity;
  if (draft.has("k_muscle"))
    p.muscle = within("k_muscle", ratio * p.elasticity * compartment_.gain_m3 / gain);
  compartment_.recoil = recoil;
  compartment_.gain_m3 = gain;
}

}  // namespace trunk
