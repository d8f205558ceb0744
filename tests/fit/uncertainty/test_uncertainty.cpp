#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <random>
#include <vector>

#include "compartment/one_compartment.hpp"
#include "math/median.hpp"
#include "problem/measured_curve.hpp"
#include "support/catch.hpp"
#include "uncertainty/uncertainty.hpp"

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
  const Compartment fitted = fit_one_compartment(measured, activation, {1e-3, 4.5}).compartment;
  CHECK(fitted.gain_m3 / fitted.time_constant_s == Approx(drive).epsilon(1e-3));
  CHECK(1.0 / fitted.time_constant_s == Approx(rate).epsilon(1e-3));
}
