#include "subject/subject_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "dynamics/recoil.hpp"
#include "dynamics/stability.hpp"
#include "estimation/start.hpp"
#include "expiration/recoil_time.hpp"
#include "math/units.hpp"
#include "records/provenance.hpp"
#include "scenarios/build_trunk.hpp"
#include "subject/fixed_parameters.hpp"
#include "trunks/read_trunk_pml.hpp"
#include "verdict/assess_fit.hpp"
#include "verdict/settling.hpp"
#include "verdict/straight_activation.hpp"

namespace trunk {
namespace {

constexpr double stiffer_wall = 1.4;       // where the effect of the wall is measured
constexpr double usual_rate_per_s = 50.0;  // k_elasticity / damping: a recoil time of half a second

std::vector<std::string> timing_names() {
  std::vector<std::string> names = parameter_names({"timing"});
  names.emplace_back("fast_fall_level");
  return names;
}

/// Returns the parameters that are estimated beside those asked for.
std::vector<std::string> beside_of(const std::vector<FixedParameter>& fixed, bool straight) {
  std::vector<std::string> names = timing_names();
  if (!straight)
    for (const std::string& knot : parameter_names({"shape"})) names.push_back(knot);
  for (const FixedParameter& held : fixed) std::erase(names, held.name());
  return names;
}

/// Returns the recoil time at which the compartment begins. Where the energy gives no recoil time, it is
/// long.
double usable_recoil_s(const RecoilTime& recoil) {
  const double longest_s = 3.0;
  return std::isfinite(recoil.median_s) ? std::min(recoil.median_s, longest_s) : longest_s;
}

/// Returns what speaks against a fit of this measurement.
Screening screened(const Measurement& measurement, double end_expiratory_m3) {
  if (measurement.signs) return trunk::screened(*measurement.signs, end_expiratory_m3);
  Screening screening;
  const double tidal_volume =
      measurement.breath ? measurement.breath->tidal_volume_m3 : measurement.tidal_volume_m3;
  if (const auto gate = subject_size(tidal_volume, end_expiratory_m3)) screening.gates.push_back(*gate);
  return screening;
}

bool is_shape(const std::string& name) {
  return free_parameter(name).group == FreeParameter::Group::shape;
}

/// Returns whether the pressure of the airway changes in the course of a breath, so that a machine may
/// breathe.
bool driven_by_airway(const Scenario& scenario) {
  return scenario.lung_acts && scenario.pleura.airway_pressure.events().size() > 1;
}

bool is_machine(const Gate& gate) {
  return gate.name == "machine_driven";
}

/// Returns the course of a measured pressure over a breath that repeats: it ends as it begins. It is above
/// that of the room, so the level at end-expiration is a part of it.
PiecewiseLinear repeating(const std::vector<double>& time_s, const MeasuredChannel& channel) {
  std::vector<double> value = channel.value;
  value.front() = value.back() = 0.5 * (value.front() + value.back());
  std::vector<PiecewiseLinear::Event> events;
  for (std::size_t i = 0; i < value.size(); ++i)
    events.push_back({time_s[i], value[i] + channel.end_expiratory});
  const double before = events.front().value;
  return PiecewiseLinear(std::move(events), before);
}

void hold(const std::vector<FixedParameter>& fixed, ScenarioFile& file) {
  Candidate c{file.scenario.parameters, file.scenario.activation};
  for (const FixedParameter& held : fixed) {
    set_value(*held.parameter, held.value, c);
    if (held.source) file.inputs.push_back(*held.source);
  }
  file.scenario.parameters = c.parameters;
  file.scenario.activation = c.activation;
}

}  // namespace

SubjectFit::SubjectFit(ScenarioFile file, Measurement measurement, FitPlan plan)
    : file_(std::move(file)), measurement_(std::move(measurement)), plan_(std::move(plan)) {
  Draft draft = drafted();
  Scenario& scenario = file_.scenario;
  if (measurement_.breath) {
    if (!file_.settings.contains("time.start")) scenario.time.start = Start::periodic;
    measured_curve_ = measured_curve_of(*measurement_.breath, plan_.weighted);
    scenario.time.duration_s = measurement_.breath->duration_s;
    if (plan_.timing != Timing::scenario)
      scenario.activation = activation_from_landmarks(*measurement_.breath);
  } else {
    measured_curve_ = {{}, {measurement_.tidal_volume_m3}, {}, {}};
    plan_.timing = Timing::scenario;
  }
  if (measurement_.breath) give_lung();
  hold(draft.fixed, file_);
  begin_ = scenario.parameters;
  if (plan_.timing == Timing::joint) draft.beside = beside_of(draft.fixed, plan_.straight);
  if (plan_.straight) plan_.priors = priors_of_straight_lines(plan_.priors, draft.beside);
  if (measurement_.breath) take_scale(draft);
  trunk_ = build_trunk(file_);
  const Screening seen_in_trace = screened(measurement_, shape_of(trunk_, trunk_.model.rest).lung_volume);
  screening_.gates = seen_in_trace.gates;
  screening_.tidal_volume_error = seen_in_trace.tidal_volume_error;
  screening_.notes.insert(screening_.notes.end(), seen_in_trace.notes.begin(), seen_in_trace.notes.end());
  if (driven_by_airway(file_.scenario)) std::erase_if(screening_.gates, is_machine);
  if (measurement_.breath) begin_with_compartment(draft);
  choose_step();
  if (measurement_.breath) calibrate_compartment(draft);
  space_ = std::make_unique<SearchSpace>(draft.names, Candidate{scenario.parameters, scenario.activation},
                                         draft.beside, plan_.priors);
}

/// Gives the trunk what its recording needs: the pressure of the airway where that was recorded, and a lung
/// where pressures in the chest or the airway were. => scenario, notes
void SubjectFit::give_lung() {
  Scenario& s = file_.scenario;
  const MeasuredBreath& breath = *measurement_.breath;
  const MeasuredChannel* airway = breath.channel(ChannelKind::airway);
  const bool needed = airway != nullptr || breath.channel(ChannelKind::pleural) != nullptr ||
                      breath.channel(ChannelKind::transdiaphragmatic) != nullptr;
  if (airway != nullptr) s.pleura.airway_pressure = repeating(breath.time_s, *airway);
  if (!needed || s.lung_acts) return;
  s.lung_acts = true;
  for (const ScalePrior& prior : scale_priors(s.parameters, true)) {
    if (prior.name == abdominal_elastance_prior) continue;
    const FreeParameter& p = free_parameter(prior.name);
    if (!p.of_lung) continue;
    Candidate c{s.parameters, s.activation};
    set_value(p, prior.mean, c);
    s.parameters = c.parameters;
  }
  screening_.notes.push_back(
      "the scenario has no lung, and a pressure in the chest needs one: the usual lung and airway are taken "
      "([lung] in the scenario gives others)");
}

/// Lets the scale of forces move along, under priors, where there is a lung or a pressure was measured.
/// => scale_, draft.beside, plan_.priors
void SubjectFit::take_scale(Draft& draft) {
  const Scenario& s = file_.scenario;
  const bool pressed = std::any_of(measured_curve_.beside.begin(), measured_curve_.beside.end(),
                                   std::mem_fn(&MeasuredObservable::is_pressure));
  if (!pressed && !s.lung_acts) return;
  for (ScalePrior prior : scale_priors(s.parameters, s.lung_acts)) {
    const auto given = std::find_if(plan_.priors.begin(), plan_.priors.end(),
                                    [&](const Prior& p) { return p.name == prior.name; });
    const bool fixed = std::any_of(draft.fixed.begin(), draft.fixed.end(),
                                   [&](const FixedParameter& f) { return f.name() == prior.name; });
    if (fixed) continue;
    if (given != plan_.priors.end()) {
      prior.mean = given->mean.value_or(prior.mean);
      prior.factor = std::exp(given->deviation);
      prior.source = given_source;
    }
    const bool abdominal = prior.name == abdominal_elastance_prior;
    if (abdominal && given != plan_.priors.end()) plan_.priors.erase(given);
    if (!abdominal && !draft.has(prior.name)) draft.beside.push_back(prior.name);
    if (!abdominal && given == plan_.priors.end())
      plan_.priors.push_back({prior.name, prior.mean, std::log(prior.factor)});
    if (prior.factor > 1.0) scale_.push_back(prior);
  }
}

/// Returns what is known of a candidate: the energy of expiration if the activation has a free shape and no
/// airway pressure drives the breath, and the abdominal elastance.
Knowledge SubjectFit::knowledge_of(bool shaped) const {
  Knowledge known;
  if (shaped && !driven_by_airway(file_.scenario)) {
    const ExpiredEnergy energy = expired_energy(*measurement_.breath);
    known.push_back({"energy of expiration", [energy, this](const Candidate& c) {
                       return energy_residual(energy, std::log(compartment_.recoil_time_s(c.parameters))).z;
                     }});
  }
  for (const ScalePrior& prior : scale_)
    if (prior.name == abdominal_elastance_prior)
      known.push_back({prior.name, [prior, this](const Candidate& c) {
                         const double elastance =
                             m3_per_litre / Pa_per_cmH2O * compartment_.abdominal_elastance(c.parameters);
                         return std::log(elastance / prior.mean) / std::log(prior.factor);
                       }});
  return known;
}

std::vector<std::string> SubjectFit::Draft::timing() const {
  std::vector<std::string> times = beside;
  std::erase_if(times, [](const std::string& name) {
    const FreeParameter& p = free_parameter(name);
    return p.group != FreeParameter::Group::timing && p.name != "fast_fall_level";
  });
  return times;
}

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

SubjectFit::Draft SubjectFit::drafted() const {
  Draft draft;
  for (const std::string& text : plan_.fixed) draft.fixed.push_back(fixed_parameter(text));
  Mistakes mistakes;
  draft.names = names_to_fit(plan_.free, draft.fixed, !measurement_.breath, mistakes);
  mistakes.settle();
  return draft;
}

/// Lets one compartment find where the search begins. => the scenario's parameters and activation
void SubjectFit::begin_with_compartment(const Draft& draft) {
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
  if (shaped && draft.has("k_elasticity") && !driven_by_airway(file_.scenario)) {
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
void SubjectFit::calibrate_compartment(const Draft& draft) {
  Scenario& scenario = file_.scenario;
  Parameters<double>& p = scenario.parameters;
  const Candidate begin{p, scenario.activation};
  const VolumeCurve curve = simulate_volume(trunk_, p, scenario.activation, scenario.time);
  if (!curve.ending.completed()) return;
  if (!measured_curve_.beside.empty()) calibrate(begin, curve, scenario.time, compartment_);
  if (driven_by_airway(file_.scenario)) return;  // a breath that no muscle drives shows no gain
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

FitProblem SubjectFit::problem() const {
  FitProblem problem{trunk_, file_.scenario.time, *space_, measured_curve_, compartment_, begin_, knowledge_};
  problem.correlation = correlation_;
  if (measurement_.breath) problem.breaths = breaths_of(*measurement_.breath, measured_curve_);
  return problem;
}

FitResults SubjectFit::results(const Estimation& e) const {
  const FitProblem asked = problem();
  return assess_fit({asked, e, measurement_.breath ? &*measurement_.breath : nullptr, screening_.gates,
                     screening_.tidal_volume_error, plan_.straight, scale_.empty() && !knowledge_.empty(),
                     straight_, searches_, scale_, driven_by_airway(file_.scenario)});
}

std::vector<Candidate> SubjectFit::draws(const Estimation& e, const Posterior& posterior,
                                         std::size_t count) const {
  const unsigned seed = plan_.estimation.search.seed;
  if (scale_.empty()) return posterior_draws(posterior, *space_, count, seed);
  const FitProblem asked = problem();
  Settling settling(asked, e);
  return posterior_draws(posterior, *space_, count, seed, std::ref(settling));
}

std::string SubjectFit::problem_text() const {
  std::string text = version_text() + to_toml(file_.scenario);
  if (file_.scenario.mesh) text += trunk_pml(file_.scenario);
  for (const double t : measured_curve_.time_s) text += fmt::format("{},", t);
  for (const MeasuredObservable& o : measured_curve_.beside)
    text += fmt::format("beside {} {},", static_cast<int>(o.kind), o.value.size());
  return text;
}

Estimation SubjectFit::carry_out(Ledger& ledger) const {
  Estimation e = estimate(problem(), plan_.estimation, ledger);
  if (!file_.scenario.step_choice || e.model.size() == 0) return e;
  const TimeGrid& grid = file_.scenario.time;
  const double error = time_step_error(trunk_.model, e.best.parameters, e.best.activation, grid);
  if (error > 2.0 * auto_time_step_tolerance)
    e.notes.push_back(fmt::format(
        "the time step of {:g} ms, chosen for the parameters at the start, is {} at the fitted ones: fit "
        "again from there (--set the fitted values) or with time.dt_ms=1",
        1e3 * grid.dt_s,
        finite(error) ? fmt::format("{:.2g} % of the tidal volume off", 100.0 * error) : "unstable"));
  return e;
}

ScenarioFile SubjectFit::fitted(const Estimation& e) const {
  ScenarioFile best = file_;
  best.scenario.parameters = e.best.parameters;
  best.scenario.activation = e.best.activation;
  return best;
}

std::string status_of(Grade grade) {
  if (grade == Grade::not_converged) return "not_converged";
  return grade == Grade::not_determined ? "not_identifiable" : "converged";
}

}  // namespace trunk
