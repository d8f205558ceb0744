#include "dynamics/stability.hpp"
#include "problem/objective.hpp"
#include "support/catch.hpp"
#include "support/trunk_objective.hpp"
#include "support/trunks.hpp"

using namespace trunk;

namespace {

/// A coarse healthy breath and a measured curve that it does not meet.
struct Case {
  Scenario scenario = test::shipped("healthy");
  Trunk trunk = make_trunk(scenario);
  MeasuredCurve measured;
  Ledger ledger;

  Case() {
    scenario.time.dt_s = 3e-3;
    scenario.activation.onset_s = 4e-4;  // its corners fall between the steps, where slopes are of one kind
    for (int i = 0; i <= 30; ++i) measured.time_s.push_back(0.15 * i);
    for (const double t : measured.time_s) measured.delta_v.push_back(400e-6 * std::sin(M_PI * t / 4.5));
    measured.delta_v[7] += 200e-6;  // an outlier
  }
  SearchSpace space(const std::vector<std::string>& names) const {
    return SearchSpace(names, {scenario.parameters, scenario.activation}, {},
                       {{"k_elasticity", 5000.0, 0.3}});
  }
};

/// The largest difference of the two, over the largest of the second.
double apart(const Slopes& exact, const Slopes& differences) {
  REQUIRE(exact);
  REQUIRE(differences);
  REQUIRE(exact->rows() == differences->rows());
  REQUIRE(exact->cols() == differences->cols());
  return (*exact - *differences).cwiseAbs().maxCoeff() / differences->cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("The exact slopes of an objective are those of central differences", "[unit][fit][slow]") {
  Case c;
  const std::vector<std::string> names = {"k_elasticity", "k_muscle",        "damping",
                                          "onset",        "fast_fall_level", "shape_rise_3"};
  const SearchSpace space = c.space(names);
  test::TrunkObjective objective(c.trunk, c.scenario.time, space, c.measured, c.ledger);
  for (const Loss loss : {Loss::squares, Loss::huber, Loss::student}) {
    objective->use_loss(loss, 1.5);
    const LeastSquares problem = objective->problem();
    REQUIRE(problem.exact_slopes);
    CHECK(apart(problem.exact_slopes(space.start()), jacobian(problem, space.start(), 1e-5)) < 2e-5);
    const LeastSquares part = with_fixed(problem, space.start(), {0, 3});
    CHECK(apart(part.exact_slopes(space.start()({0, 3})), jacobian(part, space.start()({0, 3}), 1e-5)) <
          2e-4);
  }
}

TEST_CASE("The exact slopes of pressure, excursion and EMG are those of central differences",
          "[unit][fit][slow]") {
  Case c;
  const auto add = [&](ChannelKind kind, double size, double deviation) {
    std::vector<double> value;
    for (const double t : c.measured.time_s) value.push_back(size * std::sin(M_PI * t / 4.5));
    c.measured.beside.push_back({kind, value, deviation});
  };
  add(ChannelKind::gastric, 500.0, 30.0);
  add(ChannelKind::excursion, 0.01, 1e-3);
  add(ChannelKind::emg, 40.0, 0.1);
  c.measured.beside.push_back({ChannelKind::excursion, {0.012}, 2e-3});
  const SearchSpace space = c.space({"k_elasticity", "k_muscle", "damping", "onset", "shape_rise_3"});
  test::TrunkObjective objective(c.trunk, c.scenario.time, space, c.measured, c.ledger);
  REQUIRE(objective->blocks().size() == 5);
  CHECK(objective->samples() == 4 * 31 + 1);
  const LeastSquares problem = objective->problem();
  CHECK(apart(problem.exact_slopes(space.start()), jacobian(problem, space.start(), 1e-5)) < 2e-5);
}

TEST_CASE("An offset and a drift of a pressure, and gain and offset of an EMG, change no residual",
          "[unit][fit][slow]") {
  Case c;
  const SearchSpace space = c.space({"k_elasticity", "k_muscle"});
  const Eigen::VectorXd active = activation_at(c.measured, c.scenario.activation, c.scenario.time);
  std::vector<double> pressure, emg;
  for (std::size_t i = 0; i < c.measured.time_s.size(); ++i) {
    pressure.push_back(300.0 * std::sin(c.measured.time_s[i]));
    emg.push_back(7.0 + 90.0 * active[static_cast<Eigen::Index>(i)]);
  }
  c.measured.beside = {{ChannelKind::gastric, pressure, 30.0}, {ChannelKind::emg, emg, 0.1}};
  test::TrunkObjective objective(c.trunk, c.scenario.time, space, c.measured, c.ledger);
  MeasuredCurve moved = c.measured;
  for (double& p : moved.beside[0].value) p += 40.0;
  for (double& e : moved.beside[1].value) e = 2.0 - 0.5 * e;
  test::TrunkObjective other(c.trunk, c.scenario.time, space, moved, c.ledger);
  const Eigen::VectorXd residuals = *objective->problem().at(space.start()).residuals,
                        others = *other->problem().at(space.start()).residuals;
  CHECK((residuals - others).norm() < 1e-9 * residuals.norm());
  const Block& last = objective->blocks().back();
  CHECK(residuals.segment(last.first, last.count).norm() < 1e-9);  // the EMG is the activation
}

TEST_CASE("The exact slope of a tidal volume is that of the curve where it is highest", "[unit][fit][slow]") {
  Case c;
  c.measured = {{}, {400e-6}, {}};
  const SearchSpace space({"k_muscle"}, {c.scenario.parameters, c.scenario.activation});
  test::TrunkObjective objective(c.trunk, c.scenario.time, space, c.measured, c.ledger);
  const LeastSquares problem = objective->problem();
  CHECK(apart(problem.exact_slopes(space.start()), jacobian(problem, space.start(), 1e-4)) < 1e-5);
}

TEST_CASE("Slopes are simulated once and kept in the ledger; where the model fails there are none",
          "[unit][fit][slow]") {
  Case c;
  c.scenario.time.dt_s = 0.8 * stable_time_step(c.trunk.model, c.scenario.parameters);
  const SearchSpace space = c.space({"k_elasticity", "k_muscle"});
  test::TrunkObjective objective(c.trunk, c.scenario.time, space, c.measured, c.ledger);
  const LeastSquares problem = objective->problem();
  const Slopes first = problem.exact_slopes(space.start());
  const std::size_t simulated = objective.simulated();
  CHECK(*problem.exact_slopes(space.start()) == *first);
  CHECK(objective.simulated() == simulated);

  Eigen::VectorXd unstable = space.start();
  unstable[0] = std::log(16000.0);
  CHECK(problem.exact_slopes(unstable));  // in steps of 1 ms
  unstable[0] = std::log(1e8);
  CHECK_FALSE(problem.exact_slopes(unstable));
}
