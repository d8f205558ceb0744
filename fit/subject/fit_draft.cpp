#include "subject/fit_draft.hpp"

namespace trunk {

std::vector<std::string> timing_names() {
  std::vector<std::string> names = parameter_names({"timing"});
  names.emplace_back("fast_fall_level");
  return names;
}

FitDraft::FitDraft(const std::vector<std::string>& free, const std::vector<std::string>& held,
                   bool one_number) {
  for (const std::string& text : held) fixed.push_back(fixed_parameter(text));
  Mistakes mistakes;
  names = names_to_fit(free, fixed, one_number, mistakes);
  mistakes.settle();
}

std::vector<std::string> FitDraft::timing() const {
  std::vector<std::string> times = beside;
  std::erase_if(times, [](const std::string& name) {
    const FreeParameter& p = free_parameter(name);
    return p.group != FreeParameter::Group::timing && p.name != "fast_fall_level";
  });
  return times;
}

void FitDraft::estimate_beside(bool straight) {
  beside = timing_names();
  if (!straight)
    for (const std::string& knot : parameter_names({"shape"})) beside.push_back(knot);
  for (const FixedParameter& one : fixed) std::erase(beside, one.name());
}

void FitDraft::hold(ScenarioFile& file) const {
  Candidate c{file.scenario.parameters, file.scenario.activation};
  for (const FixedParameter& one : fixed) {
    set_value(*one.parameter, one.value, c);
    if (one.source) file.inputs.push_back(*one.source);
  }
  file.scenario.parameters = c.parameters;
  file.scenario.activation = c.activation;
}

InputError no_lung(const Place& option) {
  return {option, "the scenario has no lung",
          "a table [lung] in the scenario, or a recorded pressure in the chest or the airway",
          "add the table [lung], as in --set lung.elastance_cmH2O_per_L=5 --set "
          "lung.resistance_cmH2O_s_per_L=2.5"};
}

void require_lung_for(const FitDraft& draft, const std::vector<Prior>& priors, const Scenario& scenario) {
  if (scenario.lung_acts) return;
  Mistakes mistakes;
  const auto check = [&](const std::string& option, const std::string& name) {
    for (const FreeParameter& p : free_parameters())
      if (p.of_lung && p.name == name) mistakes.add(no_lung({"--" + option + " " + name}).mistake());
  };
  for (const std::string& name : draft.names) check("free", name);
  for (const FixedParameter& held : draft.fixed) check("fix", held.name());
  for (const Prior& prior : priors) check("prior", prior.name);
  mistakes.settle();
}

}  // namespace trunk
