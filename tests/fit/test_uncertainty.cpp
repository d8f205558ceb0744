#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <random>

#include "compartment/one_compartment.hpp"
#include "uncertainty/uncertainty.hpp"
#include "uncertainty/verdict.hpp"

using namespace trunk;
using Catch::Matchers::Contains;

namespace {

Eigen::MatrixXd line_design(int n) {
  Eigen::MatrixXd j(n, 2);
  for (int i = 0; i < n; ++i) j.row(i) << 1.0, static_cast<double>(i) / n;
  return j;
}

}  // namespace

TEST_CASE("without autocorrelation the covariance is the textbook one", "[unit]") {
  const Eigen::MatrixXd j = line_design(40);
  const Eigen::MatrixXd expected = 0.25 * (j.transpose() * j).inverse();
  CHECK((least_squares_covariance(j, 0.5, 0.0) - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("under AR(1) noise the corrected covariance is the spread of repeated fits", "[property]") {
  const double rho = 0.9, sigma = 0.3;
  const int n = 100, repeats = 4000;
  const Eigen::MatrixXd j = line_design(n);
  const Eigen::MatrixXd solve = (j.transpose() * j).inverse() * j.transpose();
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (int k = 0; k < repeats; ++k) {
    Eigen::VectorXd noise(n);
    noise[0] = sigma * normal(engine);
    for (int i = 1; i < n; ++i)
      noise[i] = rho * noise[i - 1] + sigma * std::sqrt(1 - rho * rho) * normal(engine);
    const Eigen::Vector2d estimate = solve * noise;
    spread += estimate * estimate.transpose() / repeats;
  }
  const Eigen::MatrixXd corrected = least_squares_covariance(j, sigma, rho);
  const Eigen::MatrixXd naive = least_squares_covariance(j, sigma, 0.0);
  CHECK(corrected(0, 0) == Approx(spread(0, 0)).epsilon(0.1));
  CHECK(corrected(1, 1) == Approx(spread(1, 1)).epsilon(0.1));
  CHECK(naive(0, 0) < 0.3 * spread(0, 0));  // what forgetting it would claim
}

TEST_CASE("autocorrelation at lag one", "[unit]") {
  Eigen::VectorXd alternating(100), constant = Eigen::VectorXd::Ones(100);
  for (int i = 0; i < 100; ++i) alternating[i] = i % 2 == 0 ? 1.0 : -1.0;
  CHECK(lag_one_autocorrelation(alternating) == Approx(-0.99));
  CHECK(lag_one_autocorrelation(constant) == Approx(0.99));
  CHECK(lag_one_autocorrelation(Eigen::VectorXd::Zero(100)) == 0.0);
}

TEST_CASE("the verdict names what is determined and what is not", "[unit]") {
  Uncertainty u;
  u.parameters = {{"k_elasticity", "N/m", 4000, 3000, 800, 20000, false, false},
                  {"k_muscle", "N/m", 28, 21, 6, 140, false, false}};
  u.ratio = {"k_muscle/k_elasticity", "1", 0.007, 1e-5, 0.00698, 0.00702, false, true};
  const std::string text = verdict_of(u);
  CHECK_THAT(text, Contains("Only the ratio is determined: k_muscle/k_elasticity = 0.007 within 0.29 %"));
  CHECK_THAT(
      text, Contains("Not determined by this trace: k_elasticity = 4e+03 N/m, anywhere from 8e+02 to 2e+04"));
  CHECK_THAT(text, !Contains("k_muscle = "));

  u.parameters[0].identifiable = u.parameters[1].identifiable = u.identifiable = true;
  u.parameters[0].upper95 = 4100;
  u.parameters[1].upper95 = 28.7;
  CHECK_THAT(
      verdict_of(u),
      Contains("Determined by this trace, for the damping assumed: k_elasticity = 4000 N/m within 2.5 %"));
}

TEST_CASE("the one-compartment baseline finds its own constants again", "[unit]") {
  const BreathActivation<double> activation;
  const double drive = 1.4e-3, rate = 3.2;
  Target target;
  double v = 0.0;
  const double h = 1e-5;  // explicit Euler, small enough to be an independent check
  for (int n = 0; n <= 450000; ++n) {
    if (n % 2250 == 0) {
      target.time_s.push_back(n * h);
      target.delta_v.push_back(v);
    }
    v += h * (drive * activation(n * h) - rate * v);
  }
  const OneCompartment fitted = fit_one_compartment(target, activation);
  CHECK(fitted.drive == Approx(drive).epsilon(1e-3));
  CHECK(fitted.rate == Approx(rate).epsilon(1e-3));

  BreathActivation<double> wrong = activation;  // as the volume's own peak and fall would have it
  wrong.rise_s = 2.15;
  wrong.fast_fall_s = 0.9;
  wrong.slow_fall_s = 1.5;
  const BreathActivation<double> timed = timed_by_one_compartment(target, wrong);
  CHECK(timed.rise_s == Approx(2.0).epsilon(0.01));
  CHECK(timed.fast_fall_s == Approx(0.5).epsilon(0.03));
  CHECK(timed.slow_fall_s == Approx(2.0).epsilon(0.03));
}
