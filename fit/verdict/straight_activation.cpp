#include "verdict/straight_activation.hpp"

#include <algorithm>
#include <cmath>

#include "verdict/spread.hpp"

namespace trunk {
namespace {

bool is_shape(const std::string& name) {
  return free_parameter(name).group == FreeParameter::Group::shape;
}

bool is_scale(const std::string& name) {
  return free_parameter(name).group == FreeParameter::Group::mechanics && name != "fast_fall_level";
}

FitResult result_of(const Estimate& e, const char* name) {
  FitResult r{name, e.unit, e.value, e.lower95, e.upper95, Grade::assumption};
  r.assumption = "the activation is made of straight lines";
  return r;
}

}  // namespace

StraightActivation straight_activation(CompartmentFit fit, const Candidate& begin,
                                       const std::vector<std::vector<double>>& breaths) {
  const auto stays = [](const std::string& name) {  // the paper's fit knows neither a shape nor a scale
    return is_shape(name) || is_scale(name);
  };
  std::erase_if(fit.names, is_shape);
  std::erase_if(fit.beside, stays);
  std::erase_if(fit.priors, [&](const Prior& p) {
    return std::count(fit.names.begin(), fit.names.end(), p.name) +
               std::count(fit.beside.begin(), fit.beside.end(), p.name) ==
           0;
  });
  fit.priors = priors_of_straight_lines(fit.priors, fit.beside);
  fit.knowledge.clear();
  fit.recoil_s = {};
  fit.correlation =
      noise_correlation(Eigen::VectorXd::Map(fit.measured.delta_v.data(),
                                             static_cast<Eigen::Index>(fit.measured.delta_v.size())),
                        breaths);
  const Candidate best = compartment_searches(fit, begin).front().to;
  const SearchSpace space(fit.names, best, fit.beside, fit.priors);
  CompartmentModel model(fit.compartment, fit.grid, fit.measured);
  Objective objective(model, fit.grid, space, fit.measured);
  objective.use_correlation(fit.correlation);
  SearchOptions options;
  options.max_evaluations = 200;
  const SearchResult found = levenberg_marquardt(objective.problem(), space.start(), options);
  const Eigen::VectorXd volumes = *objective.model(found.best), residual_m3 = volumes - objective.measured();

  StraightActivation straight;
  straight.nrmse = std::sqrt(residual_m3.squaredNorm() / static_cast<double>(residual_m3.size())) /
                   fit.measured.tidal_volume();
  const auto local = local_fit(objective, found.best, volumes, breaths);
  if (!local) return straight;
  const Uncertainty u = assess(objective, *local);
  for (const Estimate& e : u.parameters)
    if (e.name == "k_elasticity") {
      Parameters<double> p = space.decode(found.best).parameters;
      const auto recoil_s = [&](double elasticity) {
        p.elasticity = elasticity;
        return fit.compartment.recoil_time_s(p);
      };
      FitResult recoil = result_of(e, "recoil_time_s");
      recoil.unit = "s";
      recoil.value = recoil_s(e.value);
      recoil.lower95 = recoil_s(e.upper95);
      recoil.upper95 = recoil_s(e.lower95);
      straight.results.push_back(recoil);
    }
  if (!u.ratio.name.empty()) straight.results.push_back(result_of(u.ratio, "k_muscle_over_k_elasticity"));
  for (const Estimate& e : u.parameters)
    if (e.name == "k_elasticity" || e.name == "k_muscle")
      straight.results.push_back(result_of(e, e.name.c_str()));
  return straight;
}

}  // namespace trunk
