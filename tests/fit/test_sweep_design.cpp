#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "anatomy/breath_run.hpp"
#include "errors/input_error.hpp"
#include "parallel/workers.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/design.hpp"
#include "sweep/journal.hpp"
#include "sweep/run_sweep.hpp"

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

SweepRow sweep_row(std::uint64_t run, const std::string& status, double ended_at, double measure = 1.0) {
  return {run, status, "", ended_at, false, {measure, 2.0}, {3.0}};
}

void append_rows(const std::filesystem::path& journal, const std::vector<SweepRow>& rows) {
  Journal(journal, "me").append(rows);
}

std::string bytes_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::uint64_t> runs_on_file(const std::filesystem::path& journal) {
  std::vector<std::uint64_t> runs;
  read_journal(journal, "me", [&](const SweepRow& r) {
    CHECK(r.measures == std::vector<double>{1.0, 2.0});
    runs.push_back(r.run);
  });
  return runs;
}

/// As many runs as there are lanes, of 6000 steps each.
SweepDesign runs_for_all_lanes(const test::TemporaryFolder& folder) {
  return read_sweep_design(folder.write(
      "sweep.toml", fmt::format("store = \"summary\"\nscenarios = [\"{}/scenarios/healthy.toml\"]\n[grid]\n"
                                "\"time.dt_ms\" = [0.05]\n\"time.duration_s\" = [0.3]\n"
                                "\"parameters.k_muscle_N_per_m\" = {{ from = 10, to = 60, count = {} }}\n",
                                TRUNK_SOURCE_DIR, batch_lanes())));
}

}  // namespace

TEST_CASE("a grid is every scenario with every combination, the last axis fastest", "[unit]") {
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
  CHECK_THAT(d.settings_of(d.run(3).values)[0].where, Contains("sweep.toml:4"));
}

TEST_CASE("runs of one model differ in nothing but what lanes can differ in", "[unit]") {
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

TEST_CASE("a damaged byte of a journal costs one row, also of those appended later", "[unit]") {
  const test::TemporaryFolder folder;
  append_rows(folder / "whole", {});
  const std::size_t heading = bytes_in(folder / "whole").size();
  append_rows(folder / "whole",
              {sweep_row(0, "completed", 1), sweep_row(1, "completed", 2), sweep_row(2, "completed", 3)});
  const std::string whole = bytes_in(folder / "whole");
  REQUIRE(runs_on_file(folder / "whole") == std::vector<std::uint64_t>{0, 1, 2});
  const std::size_t size = (whole.size() - heading) / 3;
  for (std::size_t at = heading; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (at % 3 > 0 ? 1 : 128));
    append_rows(folder.write("damaged", bytes), {sweep_row(3, "completed", 4)});
    std::vector<std::uint64_t> left{0, 1, 2, 3};
    left.erase(left.begin() + static_cast<std::ptrdiff_t>((at - heading) / size));
    INFO(at << " of " << heading << " + 3 x " << size);
    CHECK(runs_on_file(folder / "damaged") == left);
  }
  for (std::size_t cut = heading + 2 * size; cut < whole.size(); ++cut) {  // and half a row is none
    append_rows(folder.write("cut", whole.substr(0, cut)), {sweep_row(3, "completed", 4)});
    CHECK(runs_on_file(folder / "cut") == std::vector<std::uint64_t>{0, 1, 3});
  }
}

TEST_CASE("the row of a run that counts does not depend on the journals its rows are in", "[unit]") {
  std::vector<std::string> journals{"1-of-1", "1-of-2", "10-of-16", "2-of-2"};
  do {
    const test::TemporaryFolder folder;
    append_rows(folder / journals[0], {sweep_row(0, "timeout", 9, 1), sweep_row(1, "timeout", 5, 1),
                                       sweep_row(2, "diverged", 1, 1)});
    append_rows(folder / journals[1], {sweep_row(0, "completed", 3, 2), sweep_row(1, "invalid", 6, 2),
                                       sweep_row(2, "timeout", 1, 2)});
    append_rows(folder / journals[2], {sweep_row(0, "completed", 2, 3), sweep_row(1, "timeout", 4, 3),
                                       sweep_row(99, "completed", 1)});
    append_rows(folder / journals[3], {sweep_row(1, "timeout", 6, 2), sweep_row(1, "timeout", 5.5, 4)});
    std::vector<double> counts(3, 0.0);
    read_journals(folder / "", "me", counts.size(),
                  [&](const SweepRow& r) { counts.at(r.run) = r.measures[0]; });
    CHECK(counts[0] == 2.0);
    CHECK(counts[1] == 2.0);
    CHECK(counts[2] == (journals[0] < journals[1] ? 2.0 : 1.0));  // at once: the one read last
  } while (std::next_permutation(journals.begin(), journals.end()));
}

TEST_CASE("runs side by side have the time of all of them", "[unit][slow]") {
  const test::TemporaryFolder folder;
  const SweepDesign design = runs_for_all_lanes(folder);
  const auto seconds_between_ends = [&](const std::string& name, double timeout_s) {
    std::vector<double> at;
    const SweepFolder sweep(folder / name, design, {}, false);
    const SweepOutcome outcome = run_sweep(design, sweep, {1, {}, timeout_s, false, ""}, [](auto...) {}, {});
    if (outcome.failed > 0) return 1e9;
    sweep.for_each_row([&](const SweepRow& r) { at.push_back(r.ended_at); });
    const auto [first, last] = std::minmax_element(at.begin(), at.end());
    return *last - *first;
  };
  const auto start = std::chrono::steady_clock::now();
  seconds_between_ends("any", 0.0);
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  bool together = false;                                      // given up, they would end one by one
  for (int attempt = 0; attempt < 5 && !together; ++attempt)  // the machine may be busier than just before
    together = seconds_between_ends(std::to_string(attempt),
                                    2 * took_s / static_cast<double>(batch_lanes())) < took_s / 4;
  CHECK(together);
}

TEST_CASE("what is tried alone after its batch took too long is on file as it ends", "[unit]") {
  const test::TemporaryFolder folder;
  const SweepDesign design = runs_for_all_lanes(folder);
  const SweepFolder sweep(folder / "d", design, {}, false);
  std::vector<std::size_t> on_file;
  const auto count_rows = [&](auto...) {
    std::size_t rows = 0;
    sweep.for_each_row([&](const SweepRow&) { ++rows; });
    on_file.push_back(rows);
  };
  const SweepOutcome outcome = run_sweep(design, sweep, {1, {}, 1e-3, false, ""}, count_rows, {});
  CHECK(outcome.failed == batch_lanes());
  CHECK(outcome.finished);
  std::vector<std::size_t> one_by_one(batch_lanes());
  std::iota(one_by_one.begin(), one_by_one.end(), std::size_t{1});
  CHECK(on_file == one_by_one);
}
