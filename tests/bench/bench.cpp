// How long things take: medians over interleaved repeats, so that a slow minute of the machine meets all
// alike. Run from the root of the project: build/trunk_bench [repeats [part of a name]]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "dynamics/auto_time_step.hpp"
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

/// The same breath as each instruction set does it: alone, all lanes full, with all derivatives at once.
std::vector<Entry> breaths_by_kernel(const std::string& scenario) {
  const auto file = trunk::read_scenario("scenarios/" + scenario + ".toml");
  const auto model = trunk::build_trunk(file).model;
  const trunk::TimeGrid grid = file.scenario.time;
  std::vector<Entry> entries;
  for (const trunk::Kernel* kernel : trunk::kernels()) {
    std::vector<trunk::Trial<double>> trials;
    for (int i = 0; i < kernel->lanes; ++i) {
      trials.push_back({file.scenario.parameters, file.scenario.activation});
      trials.back().parameters.muscle *= 1.0 + 0.05 * i;
    }
    const auto curves = [=](const auto run, std::size_t count) {
      return [=] {
        std::vector<trunk::VolumeCurve> found(count);
        run(model, std::span(trials).first(count), grid, found);
        return found.front().summary.steps;
      };
    };
    const auto derivatives = [=] {
      std::vector<trunk::Trial<double>> directions(static_cast<std::size_t>(kernel->tangents),
                                                   trunk::no_change());
      for (std::size_t i = 0; i < directions.size(); ++i) *trunk::numbers(directions[i])[i] = 1.0;
      trunk::VolumeCurve curve;
      std::vector<std::vector<double>> found(directions.size());
      kernel->volume_derivatives(model, trials[0], directions, grid, curve, found);
      return curve.summary.steps;
    };
    const auto named = [&](const std::string& what) {
      return fmt::format("{}, {}", kernel->instruction_set, what);
    };
    entries.push_back({named("one"), curves(kernel->volume_curve, 1), {}});
    entries.push_back(
        {named(fmt::format("{} lanes", kernel->lanes)), curves(kernel->volume_curves, trials.size()), {}});
    entries.push_back({named(fmt::format("{} derivatives", kernel->tangents)), derivatives, {}});
  }
  return entries;
}

/// The breath with the time step that is chosen for it; choosing is not part of the time.
Entry breath_at_auto_step(const std::string& scenario) {
  const auto file = trunk::read_scenario("scenarios/" + scenario + ".toml");
  const auto model = trunk::build_trunk(file);
  const auto& [parameters, activation] = std::pair(file.scenario.parameters, file.scenario.activation);
  const auto grid =
      trunk::auto_time_step(model.model, parameters, activation, file.scenario.time.duration_s).grid;
  return {fmt::format("{}, dt auto", scenario),
          [=] { return trunk::simulate_volume(model, parameters, activation, grid).summary.steps; },
          {}};
}

}  // namespace

int main(int argc, char** argv) try {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 21;
  std::vector<Entry> entries;
  for (const char* scenario : {"healthy", "hemiparalysis_right", "published_healthy"})
    entries.push_back(breath(scenario));
  for (const char* scenario : {"healthy", "hemiparalysis_right", "published_healthy"})
    entries.push_back(breath_at_auto_step(scenario));
  for (const Entry& entry : breaths_by_kernel("healthy")) entries.push_back(entry);
  if (argc > 2)
    std::erase_if(entries, [&](const Entry& e) { return e.name.find(argv[2]) == std::string::npos; });
  for (int i = 0; i < repeats; ++i)
    for (Entry& entry : entries) entry.ms.push_back(timed_ms(entry));
  fmt::print("{:<32} {:>10} {:>10} {:>10} {:>12}\n", "one breath", "median ms", "best ms", "steps",
             "us a step");
  for (const Entry& e : entries)
    fmt::print("{:<32} {:>10.2f} {:>10.2f} {:>10} {:>12.3f}\n", e.name, median(e.ms),
               *std::min_element(e.ms.begin(), e.ms.end()), e.steps, 1e3 * median(e.ms) / e.steps);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "trunk_bench: {}\n", error.what());
  return 2;
}
