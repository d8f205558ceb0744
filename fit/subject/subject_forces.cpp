// What a fit knows of forces: the lung, the pressure of the airway, priors, and the energy of expiration.

#include <algorithm>
#include <cmath>
#include <functional>

#include "math/units.hpp"
#include "subject/subject_fit.hpp"

namespace trunk {
namespace {

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

}  // namespace

/// Gives the trunk what its recording needs: the pressure of the airway where that was recorded, and a lung
/// where pressures in the chest or the airway were, or where the scenario has an airway alone. => scenario,
/// notes
void SubjectFit::give_lung() {
  Scenario& s = file_.scenario;
  const MeasuredBreath& breath = *measurement_.breath;
  const MeasuredChannel* airway = breath.channel(ChannelKind::airway);
  const bool needed = airway != nullptr || breath.channel(ChannelKind::pleural) != nullptr ||
                      breath.channel(ChannelKind::transdiaphragmatic) != nullptr;
  if (airway != nullptr) s.pleura.airway_pressure = repeating(breath.time_s, *airway);
  if (s.lung_acts ? s.parameters.lung_elastance > 0.0 : !needed) return;
  s.lung_acts = true;
  for (const ScalePrior& prior : scale_priors(s.parameters, true)) {
    if (prior.name == abdominal_elastance_prior) continue;
    const FreeParameter& p = free_parameter(prior.name);
    Candidate c{s.parameters, s.activation};
    if (!p.of_lung || value_of(p, c) > 0.0) continue;
    set_value(p, prior.mean, c);
    s.parameters = c.parameters;
  }
  screening_.notes.push_back(
      "the scenario has no lung, and a pressure in the chest or the airway needs one: the usual lung is "
      "taken "
      "([lung] in the scenario gives others)");
}

/// Lets the scale of forces move along, under priors, where there is a lung or a pressure was measured.
/// => scale_, draft.beside, plan_.priors
void SubjectFit::take_scale(FitDraft& draft) {
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
  if (shaped && !driven_by_airway()) {
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

}  // namespace trunk
