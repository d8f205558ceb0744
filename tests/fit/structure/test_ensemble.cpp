#include <algorithm>
#include <cmath>
#include <string>

#include "records/run_record.hpp"
#include "search/multistart.hpp"
#include "structure/coarse_breath.hpp"
#include "structure/ensemble.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

using namespace trunk;

namespace {

/// A breath of 0.8 s.
Scenario short_breath(const std::string& name) {
  Scenario s = test::without_lung(name);
  s.activation.rise_s = 0.4;
  s.activation.fast_fall_s = 0.1;
  s.activation.slow_fall_s = 0.3;
  s.time.duration_s = 0.8;
  return s;
}

const Choice& declared(std::string_view name) {
  const auto all = declared_choices();
  return *std::find_if(all.begin(), all.end(), [&](const Choice& c) { return c.name == name; });
}

std::vector<Predicted> measures_at(const Scenario& s) {
  std::vector<Predicted> numbers;
  for (const NamedValue& m : measures_of(run_breath(make_trunk(s), s, 0)))
    numbers.push_back({m.name, m.unit, m.value});
  return numbers;
}

struct Asked {
  std::vector<Predicted> numbers;
  Structure structure;

  Asked(const Scenario& own, const Scenario& other, const std::vector<Choice>& choices)
      : numbers(measures_at(other)),
        structure(add_structural_intervals(own, {other}, choices, {}, {&numbers}).front()) {}

  const Predicted& operator[](std::string_view name) const {
    return *std::find_if(numbers.begin(), numbers.end(), [&](const Predicted& p) { return p.name == name; });
  }
  std::size_t place(std::string_view name) const {
    return static_cast<std::size_t>(&(*this)[name] - numbers.data());
  }
  double width(std::string_view name) const {
    return (*this)[name].structural_upper95 - (*this)[name].structural_lower95;
  }
};

/// Returns a measure in steps of 1 ms, with k_muscle found by halving so that `own` has the tidal volume.
double refitted(const Scenario& own, Scenario other, double tidal_volume_m3, double Measures::*member) {
  const Trunk trunk = make_trunk(own);
  double low = 0.5 * own.parameters.muscle, high = 2.0 * own.parameters.muscle;
  while (high - low > 1e-5 * high) {
    Scenario at = own;
    at.parameters.muscle = 0.5 * (low + high);
    (run_breath(trunk, at, 0).measures.delta_v < tidal_volume_m3 ? low : high) = at.parameters.muscle;
  }
  other.parameters.muscle = low;
  return run_breath(make_trunk(other), other, 0).measures.*member;
}

}  // namespace

TEST_CASE("A choice without a range gives an interval without a width", "[structure]") {
  Choice wall = declared("abdominal_wall"), domes = declared("dome_height");
  wall.factor = domes.factor = 1.0;
  const Asked asked(short_breath("healthy"), short_breath("hemiparalysis_right"), {wall, domes});
  for (const Predicted& p : asked.numbers) {
    INFO(p.name);
    CHECK(p.structural_lower95 == p.value);
    CHECK(p.structural_upper95 == p.value);
  }
  CHECK(std::isnan(asked.structure.shares.front()));
  CHECK(asked.structure.choices[0].low == asked.structure.choices[0].high);
}

TEST_CASE("The interval over one choice follows from finite differences", "[structure]") {
  const Scenario own = short_breath("healthy"), other = short_breath("hemiparalysis_right");
  Choice wall = declared("abdominal_wall");
  wall.factor = 1.1;
  const Asked asked(own, other, {wall});
  const double tidal_volume = run_breath(make_trunk(own), own, 0).measures.delta_v;
  const auto at = [&](double factor, double Measures::*member) {
    Scenario stiff_own = own, stiff_other = other;
    stiff_own.parameters.abdomen_factor *= factor;
    stiff_other.parameters.abdomen_factor *= factor;
    return refitted(stiff_own, stiff_other, tidal_volume, member);
  };
  for (const auto& [name, member] :
       {std::pair{"delta_l_mm", &Measures::delta_l}, {"excursion_right_mm", &Measures::excursion_right}}) {
    INFO(name);
    const double across_mm = 1e3 * std::abs(at(1.1, member) - at(1.0 / 1.1, member));
    CHECK(asked.width(name) == Approx(0.95 * across_mm).epsilon(0.05));
  }
  CHECK(asked.structure.shares.front() == 1.0);
}

TEST_CASE("Shares of every number add to one", "[structure]") {
  const std::vector<Choice> choices = {declared("abdominal_wall"), declared("paralysed_softening"),
                                       declared("dome_height"), declared("tendon_border")};
  const Asked asked(short_breath("healthy"), short_breath("hemiparalysis_right"), choices);
  REQUIRE(asked.structure.shares.size() == asked.numbers.size() * choices.size());
  for (std::size_t m = 0; m < asked.numbers.size(); ++m) {
    if (std::isnan(asked.structure.shares[m * choices.size()])) continue;
    double sum = 0.0;
    for (std::size_t i = 0; i < choices.size(); ++i) sum += asked.structure.shares[m * choices.size() + i];
    CHECK(sum == Approx(1.0));
  }
  CHECK(asked.structure.shares[choices.size() * asked.place("excursion_right_mm")] > 0.1);
  CHECK(asked.width("excursion_right_mm") > 1.0);
  CHECK(asked["delta_v_ml"].structural_lower95 < asked["delta_v_ml"].value);
  CHECK(asked["delta_v_ml"].structural_upper95 > asked["delta_v_ml"].value);
}

TEST_CASE("The subject's own breath keeps its tidal volume", "[structure]") {
  const Scenario own = short_breath("healthy");
  const Asked asked(own, own, {declared("abdominal_wall"), declared("dome_height")});
  CHECK(asked.width("delta_v_ml") <= 1e-3 * asked["delta_v_ml"].value);
  CHECK(asked.width("delta_l_mm") >= 1e-2 * asked["delta_l_mm"].value);
  CHECK(asked.structure.left_out.empty());
}

TEST_CASE("Choices that a scenario does not have are left out and named", "[structure]") {
  Scenario own = short_breath("healthy");
  own.mesh = std::make_shared<TrunkMesh>(mesh_of(own));
  const auto all = declared_choices();
  const Asked asked(own, own, {all.begin(), all.end()});
  REQUIRE(asked.structure.choices.size() == 1);
  CHECK(asked.structure.choices[0].name == "abdominal_wall");
  REQUIRE(asked.structure.left_out.size() == all.size() - 1);
  CHECK(asked.structure.left_out[0] == "paralysed_softening is left out, because nothing is paralysed");
  CHECK(asked.structure.left_out.back() == "mesh is left out, because the trunk comes from a file");
  CHECK(asked.width("delta_l_mm") > 0.0);
}

TEST_CASE("A range goes around the scenario's own value, and of two meshes one is the scenario's",
          "[structure]") {
  Scenario s = test::without_lung("healthy");
  s.parameters.abdomen_factor = 0.5;
  const Structure::Choice wall = declared_range(declared("abdominal_wall"), s);
  CHECK(wall.low == Approx(0.5 / 1.6));
  CHECK(wall.value == 0.5);
  CHECK(wall.high == Approx(0.5 * 1.6));
  const auto meshes = [&](int resolution) {
    s.geometry.resolution = resolution;
    const Structure::Choice mesh = declared_range(declared("mesh"), s);
    return std::vector<double>{mesh.low, mesh.value, mesh.high};
  };
  CHECK(meshes(1) == std::vector<double>{1, 1, 2});
  CHECK(meshes(2) == std::vector<double>{1, 2, 2});
  CHECK(meshes(3) == std::vector<double>{2, 3, 3});
  const Structure::Choice domes = declared_range(declared("dome_height"), s);
  CHECK(domes.unit == "mm");
  CHECK(domes.high == Approx(1.15 * 70.0));
}

TEST_CASE("A trunk that cannot be made leaves the interval open and is named", "[structure]") {
  const Scenario own = short_breath("healthy");
  Choice domes = declared("dome_height");
  domes.factor = 4.0;  // 280 mm do not fit under the lung
  const Asked asked(own, own, {domes});
  CHECK(std::isnan(asked["delta_l_mm"].structural_upper95));
  REQUIRE(asked.structure.left_out.size() == 1);
  CHECK(asked.structure.left_out[0].find("another dome_height") != std::string::npos);
}

TEST_CASE("Effects of one and two choices come to the interval of choices that all vary at once",
          "[structure][nightly]") {
  const Scenario own = test::without_lung("healthy"), other = test::without_lung("hemiparalysis_right");
  std::vector<Choice> choices;
  for (const Choice& c : declared_choices())
    if (!c.is_one_of_two()) choices.push_back(c);
  const Asked asked(own, other, choices);
  const double tidal_volume = CoarseTrunk(own, {}).breath(own.parameters.muscle).measures.delta_v;
  const auto n = static_cast<Eigen::Index>(choices.size());
  const LeastSquares cube{{}, Eigen::VectorXd::Constant(n, -1.0), Eigen::VectorXd::Ones(n)};
  std::vector<std::vector<double>> values(asked.numbers.size());
  for (const Eigen::VectorXd& point : sobol_starts(cube, 256, 3)) {
    Scenario moved_own = own, moved = other;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Scenario* s : {&moved_own, &moved})
        make_choice(choices[static_cast<std::size_t>(i)], point[i], *s);
    const double muscle = muscle_for(CoarseTrunk(moved_own, {}), tidal_volume, own.parameters.muscle);
    const auto measures = measures_of(CoarseTrunk(moved, {}).breath(muscle));
    for (std::size_t m = 0; m < measures.size(); ++m) values[m].push_back(measures[m].value);
  }
  for (std::size_t m = 0; m < values.size(); ++m) {
    const Predicted& p = asked.numbers[m];
    const auto& names = {"delta_v_ml", "excursion_right_mm", "excursion_left_mm", "delta_l_mm", "delta_h_mm"};
    if (std::find(names.begin(), names.end(), p.name) == names.end()) continue;
    std::sort(values[m].begin(), values[m].end());
    const double low = values[m][6], high = values[m][249], width = high - low;
    INFO(p.name << ": all at once " << low << " to " << high << "; one by one " << p.structural_lower95
                << " to " << p.structural_upper95);
    CHECK(p.structural_lower95 == Approx(low).margin(0.15 * width));
    CHECK(p.structural_upper95 == Approx(high).margin(0.15 * width));
  }
}
