#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "anatomy/breath_run.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/design.hpp"
#include "sweep/run_sweep.hpp"

using namespace trunk;

namespace {

/// As many runs as there are lanes, of 6000 steps each.
SweepDesign runs_for_all_lanes(const test::TemporaryFolder& folder) {
  return read_sweep_design(folder.write(
      "sweep.toml", fmt::format("store = \"summary\"\nscenarios = [\"{}/scenarios/healthy.toml\"]\n[grid]\n"
                                "\"time.dt_ms\" = [0.05]\n\"time.duration_s\" = [0.3]\n"
                                "\"parameters.k_muscle_N_per_m\" = {{ from = 10, to = 60, count = {} }}\n",
                                TRUNK_SOURCE_DIR, batch_lanes())));
}

}  // namespace

TEST_CASE("Runs side by side have the time of all of them", "[unit][slow]") {
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

TEST_CASE("A run that is tried alone after its batch took too long is stored when it ends", "[unit]") {
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
