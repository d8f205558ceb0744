// How long things take: medians over interleaved repeats, so that a slow minute of the machine meets all
// alike. Run from the root of the project: build/trunk_bench [repeats]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "io/scenario_file.hpp"

namespace {

struct Entry {
  std::string name;
  std::function<int()> run;  // returns the number of steps
  std::vector<double> ms;
  int steps = 0;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double timed_ms(Entry& entry) {
  const auto start = std::chrono::steady_clock::now();
  entry.steps = entry.run();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// One breath of the scenario, as a fit simulates it: the time loop and the lung volume at every step.
Entry breath(const std::string& scenario) {
  const auto file = trunk::read_scenario("scenarios/" + scenario + ".toml");
  const auto model = trunk::build_trunk(file);
  return {scenario,
          [=] {
            return trunk::simulate_volume(model, file.scenario.parameters, file.scenario.activation,
                                          file.scenario.time)
                .summary.steps;
          },
          {}};
}

/// A batch of that many breaths around the scenario, all different.
Entry batch(const std::string& scenario, int breaths) {
  const auto file = trunk::read_scenario("scenarios/" + scenario + ".toml");
  const auto model = trunk::build_trunk(file);
  std::vector<trunk::Trial<double>> trials;
  for (int i = 0; i < breaths; ++i) {
    trials.push_back({file.scenario.parameters, file.scenario.activation});
    trials.back().parameters.muscle *= 1.0 + 0.1 * i / breaths;
  }
  return {fmt::format("{} x{}", scenario, breaths),
          [=] {
            int steps = 0;
            for (const auto& curve : trunk::simulate_volumes(model, trials, file.scenario.time))
              steps += curve.summary.steps;
            return steps;
          },
          {}};
}

}  // namespace

int main(int argc, char** argv) try {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 21;
  std::vector<Entry> entries;
  for (const char* scenario : {"healthy", "hemiparalysis_right", "published_healthy"})
    for (Entry& entry : std::vector<Entry>{breath(scenario), batch(scenario, 8)}) entries.push_back(entry);
  for (int i = 0; i < repeats; ++i)
    for (Entry& entry : entries) entry.ms.push_back(timed_ms(entry));
  fmt::print("{:<24} {:>10} {:>10} {:>10} {:>12}\n", "one breath", "median ms", "best ms", "steps",
             "us a step");
  for (const Entry& e : entries)
    fmt::print("{:<24} {:>10.2f} {:>10.2f} {:>10} {:>12.3f}\n", e.name, median(e.ms),
               *std::min_element(e.ms.begin(), e.ms.end()), e.steps, 1e3 * median(e.ms) / e.steps);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "trunk_bench: {}\n", error.what());
  return 2;
}
