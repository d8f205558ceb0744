#include <algorithm>
#include <map>
#include <set>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/design.hpp"

using namespace trunk;

namespace {

SweepDesign design_of(const std::string& text) {
  const test::TemporaryFolder folder;
  folder.write("a.toml", "title = \"a\"\n");
  folder.write("b.toml", "title = \"b\"\n");
  return read_sweep_design(folder.write("sweep.toml", text));
}

const std::string head = "schema = \"trunk.sweep/1\"\nscenarios = [\"a.toml\", \"b.toml\"]\n[grid]\n";

}  // namespace

TEST_CASE("A grid is every scenario with every combination, the last axis fastest", "[unit]") {
  const SweepDesign d = design_of(head +
                                  "\"parameters.k_elasticity_N_per_m\" = [1000, 2000]\n"
                                  "\"parameters.k_muscle_N_per_m\" = { from = 10, to = 1000, count = 3, "
                                  "scale = \"log\" }\n");
  REQUIRE(d.runs() == 12);
  CHECK(d.scenario_name(5) == "a");
  CHECK(d.scenario_name(6) == "b");
  CHECK(d.run(0).values == std::vector<double>{1000, 10});
  CHECK(d.run(1).values[1] == Approx(100));
  CHECK(d.run(3).values[0] == 2000);
  CHECK(d.run(11).values[1] == Approx(1000));
  CHECK(d.settings_of(d.run(3).values)[0].key == "parameters.k_elasticity_N_per_m");
  CHECK(d.settings_of(d.run(3).values)[0].value == "2000");
  CHECK_THAT(d.settings_of(d.run(3).values)[0].at.text(), EndsWith("sweep.toml:4"));
}

TEST_CASE("Runs of one model differ only in what lanes can differ in", "[unit]") {
  const std::string rest =
      "\"parameters.k_muscle_N_per_m\" = [10, 20]\n\"time.dt_ms\" = [1, 2]\n"
      "[sample]\nmethod = \"sobol\"\npoints = 3\n";
  const SweepDesign lanes = design_of(head + rest + "\"activation.rise_s\" = { from = 1, to = 2 }\n");
  REQUIRE(lanes.runs() == 24);
  std::map<std::size_t, std::set<std::pair<std::size_t, double>>> models;
  for (std::size_t run = 0; run < lanes.runs(); ++run)
    models[lanes.model_of(run)].insert({lanes.run(run).scenario, lanes.run(run).values[1]});
  CHECK(models.size() == 4);
  for (const auto& [model, of] : models) CHECK(of.size() == 1);
  const SweepDesign shapes =
      design_of(head + rest + "\"geometry.half_depth_mm\" = { from = 100, to = 110 }\n");
  std::set<std::size_t> different;
  for (std::size_t run = 0; run < shapes.runs(); ++run) different.insert(shapes.model_of(run));
  CHECK(different.size() == 12);
}

TEST_CASE("A design that makes no sense is refused before anything runs", "[unit]") {
  CHECK_THROWS_WITH(design_of(head + "\"parameters.k_muscle\" = [1]\n"),
                    Contains("unknown key") && Contains("k_muscle_N_per_m"));
  CHECK_THROWS_WITH(design_of(head + "\"parameters.k_muscle_N_per_m\" = [-1]\n"),
                    Contains("-1") && Contains("expected"));
  CHECK_THROWS_WITH(design_of(head + "\"parameters.k_muscle_N_per_m\" = []\n"),
                    Contains("sweep.toml:4") && Contains("expected a list"));
  CHECK_THROWS_WITH(design_of(head + "\"parameters.k_muscle_N_per_m\" = { from = 1, to = 2, count = 2.5 }\n"),
                    Contains("whole number"));
  CHECK_THROWS_WITH(design_of(head + "parameters = 3\n"), Contains("full name in quotes"));
  CHECK_THROWS_WITH(design_of("scenarios = [\"missing.toml\"]\n"), Contains("missing.toml"));
  CHECK_THROWS_WITH(design_of("scenario = [\"a.toml\"]\n"), Contains("unknown key 'scenario'"));
  CHECK_THROWS_WITH(design_of("title = \"x\"\n"), Contains("names no scenarios"));
}
