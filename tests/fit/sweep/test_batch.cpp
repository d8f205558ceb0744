#include <fmt/format.h>

#include <numeric>
#include <vector>

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

/// Sweeps by a clock that goes on by a second whenever a run looks at it, thus not by how fast the machine
/// is.
struct CountedSweep {
  explicit CountedSweep(double timeout_s) {
    const test::TemporaryFolder folder;
    const SweepDesign design = runs_for_all_lanes(folder);
    const SweepFolder sweep(folder / "d", design, {}, false);
    const auto count_rows = [&](auto...) {
      std::size_t rows = 0;
      sweep.for_each_row([&](const SweepRow&) { ++rows; });
      rows_on_file.push_back(rows);
    };
    SweepOptions options;
    options.threads = 1;
    options.timeout_s = timeout_s;
    options.clock_s = [this] { return seconds += 1.0; };
    outcome = run_sweep(design, sweep, options, count_rows, {});
  }

  double seconds = 0.0;
  std::vector<std::size_t> rows_on_file;  // when progress was noted
  SweepOutcome outcome;
};

}  // namespace

TEST_CASE("Runs side by side have the time of all of them", "[unit][slow]") {
  const double together_s = CountedSweep(0.0).seconds;
  const double each_s = together_s / static_cast<double>(batch_lanes());
  REQUIRE(each_s > 10.0);
  const CountedSweep enough(1.1 * each_s);  // too little for one alone: together they are not given up
  CHECK(enough.outcome.failed == 0);
  CHECK(enough.rows_on_file == std::vector<std::size_t>{batch_lanes()});
  const CountedSweep too_little(0.9 * each_s);
  CHECK(too_little.outcome.failed == batch_lanes());
}

TEST_CASE("A run that is tried alone after its batch took too long is stored when it ends", "[unit]") {
  const CountedSweep sweep(1.0);
  CHECK(sweep.outcome.failed == batch_lanes());
  CHECK(sweep.outcome.finished);
  std::vector<std::size_t> one_by_one(batch_lanes());
  std::iota(one_by_one.begin(), one_by_one.end(), std::size_t{1});
  CHECK(sweep.rows_on_file == one_by_one);
}
