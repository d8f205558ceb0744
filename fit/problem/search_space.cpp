#include "problem/search_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

using Scale = FreeParameter::Scale;
using Group = FreeParameter::Group;

constexpr double lowest_ratio = 1e-5, highest_ratio = 1.0;  // k_muscle / k_elasticity; our choice
constexpr double amount_of_one = 0.1;                       // natural units in one coordinate
constexpr double bend_deviation = 0.3;

std::vector<const FreeParameter*> in_table_order(const std::vector<std::string>& names) {
  std::vector<const FreeParameter*> found;
  for (const std::string& name : names) free_parameter(name);
  for (const FreeParameter& p : free_parameters())  // k_elasticity comes before k_muscle
    if (const auto count = std::count(names.begin(), names.end(), p.name); count > 1)
      throw InputError({fmt::format("--free {}", p.name)},
                       fmt::format("parameter '{}' is named twice", p.name), "each name once");
    else if (count == 1)
      found.push_back(&p);
  return found;
}

/// Returns the logarithms of the knots of rise, fast fall and slow fall. A phase includes the fixed knots at
/// its ends, except where its height is 0, which has no logarithm.
std::vector<std::vector<double>> phases(const std::array<double, ShapeKnots::count>& shape) {
  const auto logs = [&](std::size_t from, std::size_t count) {
    std::vector<double> s;
    for (std::size_t k = from; k < from + count; ++k) s.push_back(std::log(shape[k]));
    return s;
  };
  using K = ShapeKnots;
  std::vector<double> rise = logs(0, K::rise), fast = logs(K::rise, K::fast_fall),
                      slow = logs(K::rise + K::fast_fall, K::slow_fall);
  rise.push_back(0.0);
  fast.insert(fast.begin(), 0.0);
  fast.push_back(0.0);
  slow.insert(slow.begin(), 0.0);
  return {rise, fast, slow};
}

std::vector<double> bends(const std::array<double, ShapeKnots::count>& shape) {
  std::vector<double> all;
  for (const std::vector<double>& s : phases(shape))
    for (std::size_t k = 1; k + 1 < s.size(); ++k) all.push_back(s[k - 1] - 2.0 * s[k] + s[k + 1]);
  return all;
}

void require_within(const FreeParameter& p, double value, const char* what, const Place& at,
                    const std::string& remedy) {
  if (value >= p.lower && value <= p.upper) return;
  throw InputError(at, fmt::format("{} {} {:g} {}", p.name, what, value, p.unit),
                   fmt::format("{:g} to {:g}", p.lower, p.upper), remedy);
}

}  // namespace

SearchSpace::SearchSpace(const std::vector<std::string>& names, const Candidate& start,
                         const std::vector<std::string>& beside, const std::vector<Prior>& priors)
    : parameters_(in_table_order(names)), asked_for_(parameters_.size()), start_(start) {
  if (names.empty())
    throw InputError({}, "no parameter is free", "at least one, as in --free k_elasticity,k_muscle");
  for (const FreeParameter* p : in_table_order(beside))
    if (!find(p->name)) parameters_.push_back(p);
  for (std::size_t i = 0; i < size(); ++i) {
    const FreeParameter& p = parameter(i);
    require_within(p, value_of(p, start_), "starts at", {},
                   fmt::format("change {} in the scenario", p.scenario_key));
    shaped_ = shaped_ || p.group == Group::shape;
    Prior prior{std::string(p.name), {}, p.prior};
    given_.push_back(0.0);
    for (const Prior& given : priors)
      if (given.name == p.name) {
        prior = given;
        given_.back() = given.deviation;
      }
    if (prior.mean)
      require_within(p, *prior.mean, "has a prior mean of", {"--prior " + prior.name}, "change the mean");
    const double mean = prior.mean.value_or(value_of(p, start_));
    if (prior.deviation > 0.0 && p.scale == Scale::factor)
      priors_.push_back({i, std::log(mean), prior.deviation});
    else if (prior.deviation > 0.0)
      priors_.push_back({i, mean / amount_of_one, prior.deviation / amount_of_one});
  }
  for (const Prior& given : priors)
    if (std::count_if(priors.begin(), priors.end(), [&](const Prior& p) { return p.name == given.name; }) > 1)
      throw InputError({"--prior " + given.name}, "it is given twice", "once");
    else if (!find(free_parameter(given.name, {"--prior " + given.name}).name))
      throw InputError({"--prior " + given.name}, "the parameter is not fitted", "one that --free names");
}

bool SearchSpace::is_ratio(std::size_t i) const {
  return parameters_[i]->name == "k_muscle";
}

std::optional<std::size_t> SearchSpace::find(std::string_view name) const {
  for (std::size_t i = 0; i < size(); ++i)
    if (parameters_[i]->name == name) return i;
  return std::nullopt;
}

double SearchSpace::coordinate(std::size_t i, double value, double elasticity) const {
  if (parameters_[i]->scale == Scale::amount) return value / amount_of_one;
  return std::log(is_ratio(i) ? value / elasticity : value);
}

Eigen::VectorXd SearchSpace::encode(const Candidate& candidate) const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i)
    x[static_cast<Eigen::Index>(i)] =
        coordinate(i, value_of(*parameters_[i], candidate), candidate.parameters.elasticity);
  return x;
}

Candidate SearchSpace::decode(const Eigen::VectorXd& x) const {
  Candidate candidate = start_;
  for (std::size_t i = 0; i < size(); ++i) {  // k_elasticity is set before k_muscle uses it
    const double at = x[static_cast<Eigen::Index>(i)];
    const double scale = is_ratio(i) ? candidate.parameters.elasticity : 1.0;
    set_value(*parameters_[i],
              parameters_[i]->scale == Scale::amount ? amount_of_one * at : scale * std::exp(at), candidate);
  }
  return candidate;
}

Eigen::VectorXd SearchSpace::lower() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i)
    x[static_cast<Eigen::Index>(i)] =
        is_ratio(i) ? std::log(lowest_ratio) : coordinate(i, parameters_[i]->lower, 1.0);
  return x;
}

Eigen::VectorXd SearchSpace::upper() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i)
    x[static_cast<Eigen::Index>(i)] =
        is_ratio(i) ? std::log(highest_ratio) : coordinate(i, parameters_[i]->upper, 1.0);
  return x;
}

Eigen::MatrixXd SearchSpace::values_by_coordinates() const {
  const auto n = static_cast<Eigen::Index>(size());
  Eigen::MatrixXd map = Eigen::MatrixXd::Identity(n, n);
  const auto elasticity = find("k_elasticity"), muscle = find("k_muscle");
  if (elasticity && muscle)
    map(static_cast<Eigen::Index>(*muscle), static_cast<Eigen::Index>(*elasticity)) = 1.0;
  for (std::size_t i = 0; i < size(); ++i)
    if (parameters_[i]->scale == Scale::amount)
      map(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) = amount_of_one;
  return map;
}

std::vector<Candidate> SearchSpace::directions(const Eigen::VectorXd& x) const {
  const Candidate at = decode(x);
  const Eigen::MatrixXd map = values_by_coordinates();
  std::vector<Candidate> all(size(), no_change());
  for (std::size_t k = 0; k < size(); ++k) {
    const FreeParameter& p = parameter(k);
    const double unit = p.scale == Scale::amount ? 1.0 : value_of(p, at);
    for (std::size_t i = 0; i < size(); ++i)
      set_value(p, unit * map(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)), all[i]);
  }
  return all;
}

Eigen::VectorXd SearchSpace::prior_residuals(const Eigen::VectorXd& x) const {
  std::vector<double> rows;
  const auto elasticity = find("k_elasticity");
  for (const PriorRow& prior : priors_) {
    double at = x[static_cast<Eigen::Index>(prior.i)];
    if (is_ratio(prior.i))  // a prior is about k_muscle itself
      at += elasticity ? x[static_cast<Eigen::Index>(*elasticity)] : std::log(start_.parameters.elasticity);
    rows.push_back((at - prior.mean) / prior.deviation);
  }
  if (shaped_) {
    const std::vector<double> now = bends(decode(x).activation.shape),
                              before = bends(start_.activation.shape);
    for (std::size_t k = 0; k < now.size(); ++k) rows.push_back((now[k] - before[k]) / bend_deviation);
  }
  return Eigen::VectorXd::Map(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

std::vector<std::string> SearchSpace::prior_names() const {
  std::vector<std::string> names;
  for (const PriorRow& prior : priors_) names.emplace_back(parameter(prior.i).name);
  if (shaped_) names.resize(names.size() + bends(start_.activation.shape).size(), "shape");
  return names;
}

}  // namespace trunk
