#include "problem/free_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

// Abdominal pressure swings in quiet breathing grow with k_elasticity, about 1 to 40 cmH2O between these (our
// choice).
constexpr double lowest_elasticity = 400.0, highest_elasticity = 16000.0;
constexpr double lowest_ratio = 1e-5, highest_ratio = 1.0;  // k_muscle / k_elasticity; our choice

double value_of(const FreeParameter& p, const Candidate& candidate) {
  return p.field(const_cast<Candidate&>(candidate));  // the accessor serves reading and writing
}

}  // namespace

std::span<const FreeParameter> free_parameters() {
  static const FreeParameter all[] = {
      {"k_elasticity", "N/m", "parameters.k_elasticity_N_per_m", lowest_elasticity, highest_elasticity,
       [](Candidate& c) -> double& { return c.parameters.elasticity; }},
      {"k_muscle", "N/m", "parameters.k_muscle_N_per_m", 0.01, 1e4,
       [](Candidate& c) -> double& { return c.parameters.muscle; }},
      {"damping", "N s/m", "parameters.damping_N_s_per_m", 0.5, 500.0,
       [](Candidate& c) -> double& { return c.parameters.damping; }},
      {"abdomen_stiffness_factor", "1", "parameters.abdomen_stiffness_factor", 0.05, 20.0,
       [](Candidate& c) -> double& { return c.parameters.abdomen_factor; }},
      {"rise", "s", "activation.rise_s", 0.1, 10.0,
       [](Candidate& c) -> double& { return c.activation.rise_s; }},
      {"fast_fall", "s", "activation.fast_fall_s", 0.02, 10.0,
       [](Candidate& c) -> double& { return c.activation.fast_fall_s; }},
      {"fast_fall_level", "1", "activation.fast_fall_level", 0.01, 1.0,
       [](Candidate& c) -> double& { return c.activation.fast_fall_level; }},
      {"slow_fall", "s", "activation.slow_fall_s", 0.02, 20.0,
       [](Candidate& c) -> double& { return c.activation.slow_fall_s; }},
  };
  return all;
}

const FreeParameter& free_parameter(const std::string& name) {
  std::string names;
  for (const FreeParameter& p : free_parameters()) {
    if (p.name == name) return p;
    names += (names.empty() ? "" : ", ") + std::string(p.name);
  }
  throw InputError(fmt::format("there is no parameter '{}' to fit, expected one of {}", name, names));
}

SearchSpace::SearchSpace(std::vector<std::string> names, const Candidate& start) : start_(start) {
  if (names.empty())
    throw InputError("no parameter is free, expected at least one: --free k_elasticity,k_muscle");
  for (const FreeParameter& p : free_parameters())  // in the table's order, so that k_elasticity comes first
    if (const auto count = std::count(names.begin(), names.end(), p.name); count > 1)
      throw InputError(fmt::format("parameter '{}' is named twice", p.name));
    else if (count == 1)
      free_.push_back(&p);
  for (const std::string& name : names) free_parameter(name);
  for (const FreeParameter* p : free_) {
    const double value = value_of(*p, start_);
    if (!(value >= p->lower && value <= p->upper))
      throw InputError(fmt::format("{} starts at {:g} {}, expected {:g} to {:g}: change {} in the scenario",
                                   p->name, value, p->unit, p->lower, p->upper, p->scenario_key));
  }
}

bool SearchSpace::is_ratio(std::size_t i) const {
  return free_[i]->name == "k_muscle";
}

Eigen::VectorXd SearchSpace::encode(const Candidate& candidate) const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    const double scale = is_ratio(i) ? candidate.parameters.elasticity : 1.0;
    x[static_cast<Eigen::Index>(i)] = std::log(value_of(*free_[i], candidate) / scale);
  }
  return x;
}

Candidate SearchSpace::decode(const Eigen::VectorXd& x) const {
  Candidate candidate = start_;
  for (std::size_t i = 0; i < size(); ++i) {  // k_elasticity is set before k_muscle uses it
    const double scale = is_ratio(i) ? candidate.parameters.elasticity : 1.0;
    free_[i]->field(candidate) = scale * std::exp(x[static_cast<Eigen::Index>(i)]);
  }
  return candidate;
}

Eigen::VectorXd SearchSpace::lower() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i)
    x[static_cast<Eigen::Index>(i)] = std::log(is_ratio(i) ? lowest_ratio : free_[i]->lower);
  return x;
}

Eigen::VectorXd SearchSpace::upper() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i)
    x[static_cast<Eigen::Index>(i)] = std::log(is_ratio(i) ? highest_ratio : free_[i]->upper);
  return x;
}

Eigen::MatrixXd SearchSpace::log_values_by_coordinates() const {
  const auto n = static_cast<Eigen::Index>(size());
  Eigen::MatrixXd map = Eigen::MatrixXd::Identity(n, n);
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t j = 0; j < size(); ++j)
      if (is_ratio(i) && free_[j]->name == "k_elasticity")
        map(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = 1.0;
  return map;
}

}  // namespace trunk
