#include "comparison/compare.hpp"
#include "support/catch.hpp"
#include "support/result_records.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

const Tolerance usual;

/// "group name" of each difference.
std::vector<std::string> names(const Comparison& comparison) {
  std::vector<std::string> all;
  for (const Difference& d : comparison.differences) all.push_back(d.group + " " + d.name);
  return all;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("Equal records are the same, NaN included, and clock times do not count", "[comparison]") {
  RunRecord run = sample_run();
  run.measures.push_back({"delta_r", "mm", std::nan("")});
  RunRecord later = run;
  later.measures[2].value = 77;  // wall_s
  const Comparison runs = compare_runs(run, later, usual);
  CHECK(runs.same());
  CHECK(runs.compared == 1 + 2 + 3 + 1 + 1);
  CHECK(runs.farthest_m == 0.0);
  CHECK(compare_fits(sample_fit(), sample_fit(), usual).same());
}

TEST_CASE("A difference is named with both numbers", "[comparison]") {
  const RunRecord run = sample_run();
  RunRecord other = run;
  other.status = "diverged";
  other.parameters[0].value += 0.1;
  other.measures[0].value = std::nan("");
  other.curves[0].values[100] += 2;
  other.trajectory.position_m[9 * 20 + 4] += 0.5;
  const Comparison c = compare_runs(run, other, usual);
  CHECK(names(c) == Names{"run status", "parameters k_muscle", "measures delta_v", "curves dV_model",
                          "trajectory particle 1 y"});
  CHECK(c.differences[1].first == 30.7);
  CHECK(c.differences[1].second == Approx(30.8));
  CHECK(c.differences[3].time_s == Approx(0.2));
  CHECK(c.differences[3].second - c.differences[3].first == Approx(2));
  CHECK(c.farthest_m == Approx(0.5));
  CHECK(c.differences[4].time_s == Approx(0.2));
  const Comparison back = compare_runs(other, run, usual);
  CHECK(names(back) == names(c));
  CHECK(back.differences[3].first == c.differences[3].second);
}

TEST_CASE("A name in only one file is a difference, but a trajectory in only one is not", "[comparison]") {
  const RunRecord run = sample_run();
  RunRecord less = run;
  less.measures.pop_back(), less.measures.pop_back();
  less.curves.clear();
  less.trajectory = {};
  const Comparison c = compare_runs(run, less, usual);
  CHECK(names(c) == Names{"measures delta_l", "curves dV_model"});
  CHECK(c.differences[0].note == "only in the first");
  CHECK(compare_runs(less, run, usual).differences[1].note == "only in the second");
  RunRecord two_particles = run;
  two_particles.trajectory.particles = 2;
  CHECK(names(compare_runs(run, two_particles, usual)) == Names{"trajectory position"});
}

TEST_CASE("The tolerance is relative, with a floor", "[comparison]") {
  RunRecord run, other;
  const auto same = [&](double a, double b, const Tolerance& tolerance) {
    run.measures = {{"x", "mm", a}};
    other.measures = {{"x", "mm", b}};
    return compare_runs(run, other, tolerance).same();
  };
  CHECK(same(1000, 1000.0009, usual));
  CHECK_FALSE(same(1000, 1000.002, usual));
  CHECK(same(1e-12, -3e-10, usual));
  CHECK_FALSE(same(1e-12, 3e-9, usual));
  CHECK(same(100, 109, {0.1, 0.0}));
  CHECK_FALSE(same(100, 112, {0.1, 0.0}));
  CHECK_FALSE(same(0.0, 1e-300, {0.0, 0.0}));
}

TEST_CASE("Curves of different steps are compared where both have values", "[comparison]") {
  RunRecord fine, coarse;
  Series volume{"dV_model", "ml", "", {}};
  for (int i = 0; i <= 1000; ++i) {
    fine.curve_time_s.push_back(0.001 * i);
    volume.values.push_back(std::sin(0.01 * i));
  }
  fine.curves = {volume};
  Series some{"dV_model", "ml", "", {}};
  for (int i = 0; i <= 1000; i += 10) {
    coarse.curve_time_s.push_back(0.001 * i);
    some.values.push_back(std::sin(0.01 * i));
  }
  coarse.curves = {some};
  CHECK(compare_runs(fine, coarse, usual).same());
  CHECK(compare_runs(coarse, fine, usual).same());
  coarse.curves[0].values[50] += 0.1;
  const Comparison c = compare_runs(fine, coarse, usual);
  REQUIRE(c.differences.size() == 1);
  CHECK(c.differences[0].time_s == Approx(0.5));
  CHECK(c.differences[0].second - c.differences[0].first == Approx(0.1));
  coarse.curve_time_s.pop_back(), coarse.curves[0].values.pop_back();
  for (double& t : coarse.curve_time_s) t *= 2;
  CHECK(compare_runs(fine, coarse, usual).differences.at(0).note == "they do not last equally long");
}

TEST_CASE("Fits differ in estimates, statistics, curves and the best run", "[comparison]") {
  const FitRecord fit = sample_fit();
  FitRecord other = fit;
  other.parameters[0].best *= 1.01;
  other.parameters[1].upper95 = 505;  // was not known
  other.statistics[0].value = 2;
  other.dV_fit_m3[1] += 1e-5;
  other.best_run.measures[1].value += 1;
  other.evaluation_wall_s[0] = 100;
  CHECK(names(compare_fits(fit, other, usual)) == Names{"parameters k_elasticity",
                                                        "parameters k_muscle upper95", "statistics nrmse",
                                                        "result dV_fit", "measures delta_l"});
}

TEST_CASE("What older files could not say is no difference", "[comparison]") {
  RunRecord old = sample_run();
  RunRecord now = old;
  now.measures.push_back({"gastric_swing_cmH2O", "cmH2O", 9.7});
  now.measures.push_back({"recoil_time_s", "s", 0.12});
  CHECK(compare_runs(old, now, usual).same());
  CHECK(compare_runs(now, old, usual).same());
  old.measures.push_back({"recoil_time_s", "s", 0.13});
  CHECK(names(compare_runs(old, now, usual)) == Names{"measures recoil_time_s"});
  now.measures.push_back({"pleural_swing_cmH2O", "cmH2O", -3.2});  // only one of them has a lung
  CHECK(names(compare_runs(old, now, usual)) ==
        Names{"measures recoil_time_s", "measures pleural_swing_cmH2O"});
}

TEST_CASE("A run from before breathing could repeat began at rest", "[comparison]") {
  RunRecord old = sample_run();
  old.status = "completed";
  RunRecord now = old;
  now.measures.push_back({"end_expiratory_above_relaxation_ml", "ml", 0.0});
  CHECK(compare_runs(old, now, usual).same());
  CHECK(compare_runs(now, old, usual).same());
  now.measures.back().value = 12.0;
  CHECK(names(compare_runs(old, now, usual)) == Names{"measures end_expiratory_above_relaxation_ml"});
}
