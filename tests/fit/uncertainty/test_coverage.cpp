// Do the intervals keep their promise? The simulator's own breath with noise, fitted again and again.

#include <random>

#include "search/minimise.hpp"
#include "support/catch.hpp"
#include "support/trunk_objective.hpp"
#include "support/trunks.hpp"
#include "uncertainty/bootstrap.hpp"
#include "uncertainty/likelihood_surface.hpp"

using namespace trunk;

namespace {

/// A short breath at a long step: quick, and with enough lag for k_elasticity to be determined.
Scenario short_breath() {
  Scenario s = test::shipped("healthy");
  s.time = {4e-3, 1.2};
  s.activation.rise_s = 0.5;
  s.activation.fast_fall_s = 0.15;
  s.activation.slow_fall_s = 0.4;
  return s;
}

struct Study {
  Scenario scenario = short_breath();
  Trunk trunk = make_trunk(scenario);
  SearchSpace space{{"k_elasticity", "k_muscle"}, {scenario.parameters, scenario.activation}};
  Ledger ledger;
  std::vector<double> time_s, truth;  // m3

  Study() {
    for (int i = 0; i <= 100; ++i) time_s.push_back(scenario.time.duration_s * i / 100);
    const VolumeCurve curve = simulate_volume(trunk, scenario.parameters, scenario.activation, scenario.time);
    const Eigen::VectorXd v = sampled(curve.delta_v, scenario.time.dt_s, time_s);
    truth.assign(v.data(), v.data() + v.size());
  }

  MeasuredCurve noisy(double rho, std::mt19937_64& engine) const {
    MeasuredCurve measured{time_s, truth, {}};
    std::normal_distribution<double> normal;
    const double sigma = 4e-6;
    double noise = sigma * normal(engine);
    for (double& v : measured.delta_v) {
      v += noise;
      noise = rho * noise + sigma * std::sqrt(1 - rho * rho) * normal(engine);
    }
    return measured;
  }
};

std::optional<LocalFit> fit_at(Objective& objective, const Eigen::VectorXd& x) {
  return local_fit(objective, x, *objective.model(x));
}

struct Counts {
  int repeats = 0, corrected[2] = {}, naive[2] = {}, joint = 0, profile[2] = {};
};

Counts coverage(double rho, int repeats) {
  Study study;
  std::mt19937_64 engine(2026);
  const double truth[2] = {study.scenario.parameters.elasticity, study.scenario.parameters.muscle};
  Counts counts;
  for (int k = 0; k < repeats; ++k) {
    const MeasuredCurve measured = study.noisy(rho, engine);
    test::TrunkObjective objective(study.trunk, study.scenario.time, study.space, measured, study.ledger);
    const SearchResult best = levenberg_marquardt(objective->problem(), study.space.start(), {});
    REQUIRE(best.converged);
    const auto fit = fit_at(*objective, best.best);
    REQUIRE(fit);
    const Uncertainty u = assess(*objective, *fit);
    for (std::size_t i = 0; i < 2; ++i) {
      const Estimate& e = u.parameters[i];
      counts.corrected[i] += e.lower95 < truth[i] && truth[i] < e.upper95;
      counts.naive[i] += e.naive95.lower < truth[i] && truth[i] < e.naive95.upper;
    }
    ++counts.repeats;
  }
  return counts;
}

}  // namespace

TEST_CASE("Nominal 95 % intervals cover the truth in 90 to 98 % of 300 repeats", "[nightly][slow]") {
  for (const double rho : {0.0, 0.9}) {
    const Counts c = coverage(rho, 300);
    for (int i = 0; i < 2; ++i) {
      const double corrected = 100.0 * c.corrected[i] / c.repeats, naive = 100.0 * c.naive[i] / c.repeats;
      WARN("rho " << rho << ", parameter " << i << ": corrected " << corrected << " %, as if independent "
                  << naive << " %");
      CHECK(corrected >= 90.0);
      CHECK(corrected <= 98.0);
      if (rho > 0.0) CHECK(naive < 60.0);
    }
  }
}

TEST_CASE("Profile, likelihood surface and bootstrap agree with the local interval where it is narrow",
          "[property][slow]") {
  Study study;
  std::mt19937_64 engine(5);
  const MeasuredCurve measured = study.noisy(0.0, engine);
  test::TrunkObjective objective(study.trunk, study.scenario.time, study.space, measured, study.ledger);
  const SearchResult best = levenberg_marquardt(objective->problem(), study.space.start(), {});
  const auto fit = fit_at(*objective, best.best);
  REQUIRE(fit);
  const Uncertainty u = assess(*objective, *fit);
  const auto all = profiles(*objective, *fit);
  const LikelihoodSurface surface = likelihood_surface(*objective, *fit, 11);
  const Bootstrap boot = bootstrap(*objective, *fit, 200, 1);
  CHECK(surface.closed);
  for (std::size_t i = 0; i < 2; ++i) {
    const Estimate& e = u.parameters[i];
    CAPTURE(e.name, e.lower95, e.upper95);
    const double width = std::log(e.upper95 / e.lower95);
    CHECK(std::log(all[i].interval95.upper / all[i].interval95.lower) == Approx(width).epsilon(0.15));
    const double white = std::log(e.naive95.upper / e.naive95.lower);  // as the noise is here
    CHECK(std::log(boot.interval95[i].upper / boot.interval95[i].lower) == Approx(white).epsilon(0.25));
    CHECK(boot.interval95[i].lower < e.value);
    CHECK(e.value < boot.interval95[i].upper);
    CHECK(all[i].deviance[4] == Approx(0.0).margin(1e-6));
  }
  // The joint region of two is wider than the interval of one by sqrt(2 F(2, n)) / t: about 2.5 / 2.
  const double joint = std::log(surface.region95[0].upper / surface.region95[0].lower),
               alone = std::log(u.parameters[0].upper95 / u.parameters[0].lower95);
  CHECK(joint / alone == Approx(1.25).epsilon(0.1));
}
