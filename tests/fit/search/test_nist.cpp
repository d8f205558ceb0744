// Problems whose answers others have certified, through the same search and the same standard errors as a
// breath.

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "search/minimise.hpp"
#include "support/catch.hpp"
#include "uncertainty/noise.hpp"

using namespace trunk;

namespace {

using Numbers = std::vector<double>;
using Law = double (*)(const Numbers& b, double x);

const std::map<std::string, Law> laws = {
    {"Misra1a", [](const Numbers& b, double x) { return b[0] * (1.0 - std::exp(-b[1] * x)); }},
    {"Thurber",
     [](const Numbers& b, double x) {
       return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])));
     }},
    {"MGH09",
     [](const Numbers& b, double x) { return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]); }},
    {"DanWood", [](const Numbers& b, double x) { return b[0] * std::pow(x, b[1]); }},
    {"Rat42", [](const Numbers& b, double x) { return b[0] / (1.0 + std::exp(b[1] - b[2] * x)); }},
    {"Eckerle4",
     [](const Numbers& b, double x) {
       const double z = (x - b[2]) / b[1];
       return b[0] / b[1] * std::exp(-0.5 * z * z);
     }},
    {"MGH17", [](const Numbers& b,
                 double x) { return b[0] + b[1] * std::exp(-x * b[3]) + b[2] * std::exp(-x * b[4]); }},
};

/// Coordinates are the parameters over their start, within 30 times that on either side.
struct Regression {
  Law law;
  Numbers start, x, y;

  Numbers natural(const Eigen::VectorXd& coordinates) const {
    Numbers b;
    for (std::size_t i = 0; i < start.size(); ++i)
      b.push_back(start[i] * coordinates[static_cast<Eigen::Index>(i)]);
    return b;
  }
  Eigen::VectorXd residuals(const Eigen::VectorXd& coordinates) const {
    const Numbers b = natural(coordinates);
    Eigen::VectorXd r(static_cast<Eigen::Index>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) r[static_cast<Eigen::Index>(i)] = law(b, x[i]) - y[i];
    return r;
  }
  LeastSquares problem() const {
    const auto outcomes = [this](const std::vector<Eigen::VectorXd>& some) {
      std::vector<Outcome> all;
      for (const Eigen::VectorXd& c : some) {
        const Eigen::VectorXd r = residuals(c);
        if (std::isfinite(r.squaredNorm()))
          all.push_back({r, r.squaredNorm()});
        else
          all.push_back({std::nullopt, 1e30});
      }
      return all;
    };
    const auto n = static_cast<Eigen::Index>(start.size());
    return {outcomes, Eigen::VectorXd::Constant(n, -30.0), Eigen::VectorXd::Constant(n, 30.0)};
  }
};

}  // namespace

TEST_CASE("Certified regressions give the certified values and standard errors", "[unit]") {
  std::ifstream file(TRUNK_SOURCE_DIR "/reference/nist/nonlinear_regression.json");
  const auto problems = nlohmann::json::parse(file)["problems"];
  REQUIRE(problems.size() == 7);
  for (const auto& certified : problems)
    for (const Numbers& start : certified["starts"].get<std::vector<Numbers>>()) {
      const Regression regression{laws.at(certified["name"]), start, certified["x"], certified["y"]};
      INFO(certified["name"] << " from " << start[0]);
      SearchOptions options;
      options.algorithm = "lm";
      options.max_evaluations = 20000;
      options.objective_tolerance = 1e-15;
      options.coordinate_tolerance = 1e-10;
      const LeastSquares problem = regression.problem();
      const auto n = static_cast<Eigen::Index>(start.size());
      const SearchResult r = minimise(problem, Eigen::VectorXd::Ones(n), options);
      REQUIRE(r.converged);
      CHECK(r.objective == Approx(certified["sum_of_squares"].get<double>()).epsilon(1e-8));
      const Numbers estimates = certified["estimates"], errors = certified["standard_errors"],
                    b = regression.natural(r.best);
      const Eigen::MatrixXd slopes = *jacobian(problem, r.best, 1e-4);
      const Noise noise = estimate_noise(regression.residuals(r.best), slopes);
      const Eigen::MatrixXd covariance =
          least_squares_covariance(slopes, noise_covariance(slopes.rows(), noise.white_deviation, 0.0));
      CHECK(noise.freedom == static_cast<double>(slopes.rows() - n));
      for (std::size_t i = 0; i < b.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        CHECK(b[i] == Approx(estimates[i]).epsilon(1e-5));
        CHECK(std::abs(start[i]) * std::sqrt(covariance(k, k)) == Approx(errors[i]).epsilon(1e-3));
      }
    }
}
