#include <catch2/catch.hpp>

#include <numeric>

#include "errors/input_error.hpp"
#include "parallel/workers.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/design.hpp"

using namespace trunk;
using Catch::Matchers::Contains;

namespace {

SweepDesign design_of(const std::string& text) {
  const test::TemporaryFolder folder;
  folder.write("a.toml", "title = \"a\"\n");
  folder.write("b.toml", "title = \"b\"\n");
  return read_sweep_design(folder.write("sweep.toml", text));
}

const std::string head = "schema = \"trunk.sweep/1\"\nscenarios = [\"a.toml\", \"b.toml\"]\n[grid]\n";

}  // namespace

TEST_CASE("a grid is every scenario with every combination, the last axis fastest", "[unit]") {
  const SweepDesign d = design_of(head +
                                  "\"parameters.k_elasticity_N_per_m\" = [1000, 2000]\n"
                                  "\"parameters.k_muscle_N_per_m\" = { from = 10, to = 1000, count = 3, "
                                  "scale = \"log\" }\n");
  REQUIRE(d.runs() == 12);
  CHECK(d.scenario_of(5).filename() == "a.toml");
  CHECK(d.scenario_of(6).filename() == "b.toml");
  CHECK(d.values_of(0) == std::vector<double>{1000, 10});
  CHECK(d.values_of(1)[1] == Approx(100));
  CHECK(d.values_of(3)[0] == 2000);
  CHECK(d.values_of(11)[1] == Approx(1000));
  CHECK(d.settings_of(3)[0].key == "parameters.k_elasticity_N_per_m");
  CHECK(d.settings_of(3)[0].value == "2000");
  CHECK_THAT(d.settings_of(3)[0].where, Contains("sweep.toml:4"));
}

TEST_CASE("a design that makes no sense is refused before anything runs", "[unit]") {
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

TEST_CASE("work is done once each on any number of threads, and stops when told to", "[unit]") {
  std::vector<std::size_t> items(500);
  std::iota(items.begin(), items.end(), std::size_t{0});
  for (unsigned threads : {1u, 2u, 7u}) {
    std::vector<int> seen(items.size(), 0);
    work_off<std::size_t>(
        items, threads, {}, [](std::size_t i) { return i; }, [&](std::size_t i) { ++seen[i]; });
    CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  }
  int taken = 0;
  work_off<std::size_t>(
      items, 2, [&] { return taken >= 10; }, [](std::size_t i) { return i; }, [&](std::size_t) { ++taken; });
  CHECK(taken >= 10);
  CHECK(taken < 100);
  CHECK_THROWS_WITH(work_off<std::size_t>(
                        items, 2, {}, [](std::size_t i) { return i; },
                        [](std::size_t) { throw std::runtime_error("disk full"); }),
                    "disk full");
}
