#include <Eigen/Dense>
#include <random>
#include <vector>

#include "compartment/one_compartment.hpp"
#include "math/median.hpp"
#include "problem/measured_curve.hpp"
#include "support/catch.hpp"
#include "uncertainty/uncertainty.hpp"
#include "uncertainty/verdict.hpp"

using namespace trunk;

namespace {

Eigen::MatrixXd line_design(int n) {
  Eigen::MatrixXd j(n, 2);
  for (int i = 0; i < n; ++i) j.row(i) << 1.0, static_cast<double>(i) / n;
  return j;
}

/// AR(1) of deviation sigma.
Eigen::VectorXd ar1(int n, double rho, double sigma, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd noise(n);
  noise[0] = sigma * normal(engine);
  for (int i = 1; i < n; ++i)
    noise[i] = rho * noise[i - 1] + sigma * std::sqrt(1 - rho * rho) * normal(engine);
  return noise;
}

}  // namespace

TEST_CASE("Without autocorrelation and priors the covariance is the textbook's", "[unit]") {
  const Eigen::MatrixXd j = line_design(40);
  const Eigen::MatrixXd expected = 0.25 * (j.transpose() * j).inverse();
  CHECK((least_squares_covariance(j, noise_covariance(40, 0.5, 0.0)) - expected).norm() <
        1e-12 * expected.norm());
}

TEST_CASE("A prior adds its information to that of the data", "[unit]") {
  const Eigen::MatrixXd j = line_design(40);
  Eigen::MatrixXd rows(41, 2);
  rows << j, Eigen::RowVector2d(0.0, 4.0);  // the slope is known to 1/4
  const Eigen::MatrixXd information =
      j.transpose() * j + Eigen::Vector2d(0.0, 16.0).asDiagonal().toDenseMatrix();
  const Eigen::MatrixXd expected = information.inverse();
  CHECK((least_squares_covariance(rows, noise_covariance(40, 1.0, 0.0)) - expected).norm() <
        1e-12 * expected.norm());
}

TEST_CASE("Under AR(1) noise the corrected covariance is the spread of repeated fits", "[property]") {
  const double rho = 0.9, sigma = 0.3;
  const int n = 100, repeats = 4000;
  const Eigen::MatrixXd j = line_design(n);
  const Eigen::MatrixXd solve = (j.transpose() * j).inverse() * j.transpose();
  std::mt19937_64 engine(7);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (int k = 0; k < repeats; ++k) {
    const Eigen::Vector2d estimate = solve * ar1(n, rho, sigma, engine);
    spread += estimate * estimate.transpose() / repeats;
  }
  const Eigen::MatrixXd corrected = least_squares_covariance(j, noise_covariance(n, sigma, rho));
  const Eigen::MatrixXd naive = least_squares_covariance(j, noise_covariance(n, sigma, 0.0));
  CHECK(corrected(0, 0) == Approx(spread(0, 0)).epsilon(0.1));
  CHECK(corrected(1, 1) == Approx(spread(1, 1)).epsilon(0.1));
  CHECK(naive(0, 0) < 0.3 * spread(0, 0));  // what forgetting it would claim
}

TEST_CASE("Noise is estimated without bias, although the fit removes part of it", "[property][slow]") {
  const int n = 200, repeats = 200;
  Eigen::MatrixXd j(n, 7);  // as smooth as the directions of a breath
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 7; ++k) j(i, k) = std::cos(k * 3.14159265358979 * (i + 0.5) / n);
  const Eigen::MatrixXd leave =
      Eigen::MatrixXd::Identity(n, n) - j * (j.transpose() * j).inverse() * j.transpose();
  std::mt19937_64 engine(11);
  for (const double rho : {0.0, 0.9}) {
    double lag_one = 0.0;
    std::vector<double> rhos, deviations;
    for (int k = 0; k < repeats; ++k) {
      const Eigen::VectorXd left = leave * ar1(n, rho, 2.0, engine);
      const Noise noise = estimate_noise(left, j);
      rhos.push_back(noise.rho);
      deviations.push_back(noise.deviation);
      lag_one += autocorrelation(left, 1) / repeats;
    }
    // Medians: a repeat in a hundred looks like a random walk, whose deviation has no bound.
    const double median_rho = median(rhos), median_deviation = median(deviations);
    CAPTURE(rho, median_rho, median_deviation, lag_one);
    CHECK(median_rho > rho - 0.02);  // never less than there was; more where the data leave that open
    CHECK(median_rho < (rho > 0.0 ? 0.99 : 0.15));
    CHECK(median_deviation > 1.8);
    if (rho == 0.0) CHECK(median_deviation == Approx(2.0).epsilon(0.1));
    if (rho > 0.0) CHECK(lag_one < rho - 0.04);  // what the residuals alone would say
  }
}

TEST_CASE("The autocorrelation at lag one has its known values", "[unit]") {
  Eigen::VectorXd alternating(100), constant = Eigen::VectorXd::Ones(100);
  for (int i = 0; i < 100; ++i) alternating[i] = i % 2 == 0 ? 1.0 : -1.0;
  CHECK(autocorrelation(alternating, 1) == Approx(-0.99));
  CHECK(autocorrelation(alternating, 2) == Approx(0.98));
  CHECK(autocorrelation(constant, 1) == Approx(0.99));
  CHECK(autocorrelation(Eigen::VectorXd::Zero(100), 1) == 0.0);
}

TEST_CASE("The information criterion is that of the AR(1) likelihood", "[unit]") {
  std::mt19937_64 engine(3);
  const Eigen::VectorXd r = ar1(150, 0.6, 1.0, engine);
  const double rho = autocorrelation(r, 1);
  // -2 log L of a normal with the full covariance, the deviation at its best, constants dropped.
  const Eigen::MatrixXd s = noise_covariance(150, 1.0, rho);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(s);
  const double variance = r.dot(cholesky.solve(r)) / 150.0;
  const double log_determinant = 2.0 * Eigen::MatrixXd(cholesky.matrixL()).diagonal().array().log().sum();
  // innovations have variance (1 - rho^2) sigma^2
  const double expected = 150.0 * std::log(variance) + log_determinant;
  CHECK(ar1_bic(r, 3) - 5.0 * std::log(150.0) == Approx(expected).epsilon(1e-9));
  CHECK(ar1_bic(r, 4) - ar1_bic(r, 3) == Approx(std::log(150.0)));
}

TEST_CASE("Robust losses keep small residuals and weigh outliers less", "[unit]") {
  const Eigen::Vector4d r(0.0, -0.1, 1.0, -50.0);
  CHECK(robust_residuals(r, Loss::squares, 1.0) == r);
  const Eigen::Vector4d huber = robust_residuals(r, Loss::huber, 1.0),
                        student = robust_residuals(r, Loss::student, 1.0);
  CHECK(huber.head(3) == r.head(3));
  CHECK(huber[3] == Approx(-std::sqrt(1.345 * (2 * 50.0 - 1.345))));
  CHECK(student[3] == Approx(-std::sqrt(5.0 * std::log(1 + 2500.0 / 4.0))));
  CHECK(student[1] == Approx(-0.1 * std::sqrt(1.25)).epsilon(0.01));
  CHECK(robust_residuals(2.0 * r, Loss::huber, 2.0) == 2.0 * huber);
  CHECK(median_deviation(Eigen::Vector3d(-2.0, 1.0, 100.0)) == Approx(2.9652));
}

TEST_CASE("The verdict names what is determined and what is not", "[unit]") {
  Uncertainty u;
  u.parameters = {{"k_elasticity", "N/m", 4000, 3000, 800, 20000, false, false, {}},
                  {"k_muscle", "N/m", 28, 21, 6, 140, false, false, {}}};
  u.ratio = {"k_muscle/k_elasticity", "1", 0.007, 1e-5, 0.00698, 0.00702, false, true, {}};
  const std::string text = verdict_of(u);
  CHECK_THAT(text,
             Contains("This trace determines only the ratio: k_muscle/k_elasticity = 0.007 within 0.29 %"));
  CHECK_THAT(text, Contains("It does not determine: k_elasticity = 4e+03 N/m, anywhere from 8e+02 to 2e+04"));
  CHECK_THAT(text, !Contains("k_muscle = "));

  u.parameters[0].identifiable = u.parameters[1].identifiable = u.identifiable = true;
  u.parameters[0].upper95 = 4100;
  u.parameters[1].upper95 = 28.7;
  CHECK_THAT(
      verdict_of(u),
      Contains("This trace determines, if the damping is as assumed: k_elasticity = 4000 N/m within 2.5 %"));

  Uncertainty two;
  two.parameters = {{"k_elasticity", "N/m", 4000, 3000, 800, 20000, false, false, {}},
                    {"damping", "N s/m", 20, 15, 4, 100, false, false, {}}};
  two.combinations = {{{-0.52, 1.0}, 0.03}, {{1.0, 0.52}, 2.0}};
  CHECK_THAT(verdict_of(two),
             Contains("This trace determines only a combination: k_elasticity^-0.52 damping to 3 %"));
}

TEST_CASE("The verdict says what comes from a bound, an open profile or a prior", "[unit]") {
  Uncertainty u;
  u.parameters = {{"k_elasticity", "N/m", 4000, 300, 3500, 4600, false, true, {}},
                  {"k_muscle", "N/m", 28, 2, 24, 33, false, true, {}}};
  u.ratio = {"k_muscle/k_elasticity", "1", 0.007, 1e-5, 0.00698, 0.00702, false, true, {}};
  conclude(u);
  REQUIRE(u.identifiable);

  Uncertainty open = u;
  open.parameters[0].identifiable = false;
  open.parameters[0].open_profile = Interval{3600.0, std::numeric_limits<double>::infinity()};
  conclude(open);
  CHECK_FALSE(open.identifiable);
  CHECK_THAT(open.verdict, Contains("k_elasticity (at least 3.6e+03 N/m, no upper limit found)"));
  CHECK_THAT(open.verdict, !Contains("4600"));

  Uncertainty stopped = u;
  stopped.parameters[0].at_bound = true;
  stopped.parameters[0].identifiable = stopped.parameters[1].identifiable = false;
  conclude(stopped);
  CHECK_THAT(stopped.verdict, Contains("This trace determines only the ratio"));
  CHECK_THAT(stopped.verdict, Contains("k_elasticity (stopped at its bound, 4e+03 N/m)"));
  CHECK_THAT(stopped.verdict, !Contains("k_muscle = "));

  Uncertainty given = u;
  given.parameters[0].prior = 0.1;  // the interval is hardly narrower
  conclude(given);
  CHECK_THAT(given.verdict, Contains("This trace with the given priors determines"));
  CHECK_THAT(given.verdict,
             Contains("Most of what is known about k_elasticity comes from --prior, not from the trace"));
  given.parameters[0].prior = 1.0;
  conclude(given);
  CHECK_THAT(given.verdict, !Contains("Most of"));
}

TEST_CASE("The one-compartment fit finds its own constants again", "[unit]") {
  const BreathActivation<double> activation;
  const double drive = 1.4e-3, rate = 3.2;
  MeasuredCurve measured;
  double v = 0.0;
  const double h = 1e-5;  // explicit Euler, small enough to be an independent check
  for (int n = 0; n <= 450000; ++n) {
    if (n % 2250 == 0) {
      measured.time_s.push_back(n * h);
      measured.delta_v.push_back(v);
    }
    v += h * (drive * activation(n * h) - rate * v);
  }
  const OneCompartment fitted = fit_one_compartment(measured, activation);
  CHECK(fitted.drive == Approx(drive).epsilon(1e-3));
  CHECK(fitted.rate == Approx(rate).epsilon(1e-3));

  BreathActivation<double> wrong = activation;  // as the volume's own peak and fall would have it
  wrong.rise_s = 2.15;
  wrong.fast_fall_s = 0.9;
  wrong.slow_fall_s = 1.5;
  const BreathActivation<double> timed = timed_by_one_compartment(measured, wrong);
  CHECK(timed.rise_s == Approx(2.0).epsilon(0.01));
  CHECK(timed.fast_fall_s == Approx(0.5).epsilon(0.03));
  CHECK(timed.slow_fall_s == Approx(2.0).epsilon(0.03));
}
