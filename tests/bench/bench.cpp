// What the benchmark script asks to be timed. Reads lines from its input, each the name of a case, and
// answers each with a line of JSON: `ms`, the time of the work itself, and what else there is to say. Run
// from the root of the project; `build/trunk_bench CASE...` times these once.

#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "anatomy/breath_run.hpp"
#include "dynamics/auto_time_step.hpp"
#include "dynamics/kernel.hpp"
#include "dynamics/recoil.hpp"
#include "dynamics/stability.hpp"
#include "dynamics/volume_curve.hpp"
#include "estimation/estimate.hpp"
#include "math/units.hpp"
#include "parallel/workers.hpp"
#include "scenarios/read_scenario.hpp"

namespace {

using namespace trunk;
using Trials = std::vector<Trial<double>>;

/// The work to be timed, and what to add to the answer (text of JSON members) once it is done.
struct Case {
  std::function<void()> work;
  std::function<std::string()> remark = [] { return std::string(); };
};

struct Subject {
  Scenario scenario;
  Trunk trunk;
};

Subject subject(const std::string& name, int resolution = 1) {
  auto file = read_scenario("scenarios/" + name + ".toml");
  file.scenario.geometry.resolution = resolution;
  return {file.scenario, make_trunk(file.scenario)};
}

/// The same trunk with a lung and an airway, or without; everything else is the same.
Subject breathing_air(bool with_lung) {
  Scenario s = read_scenario("scenarios/healthy_no_lung.toml").scenario;
  s.lung_acts = with_lung;
  s.parameters.lung_elastance = 5.0 * Pa_per_cmH2O / m3_per_litre;
  s.parameters.resistance = 2.5 * Pa_per_cmH2O / m3_per_litre;
  s.time = {};
  return {s, make_trunk(s)};
}

Trials different(const Scenario& s, std::size_t count) {
  Trials trials(count, {s.parameters, s.activation});
  for (std::size_t i = 0; i < count; ++i)
    trials[i].parameters.muscle *= 1.0 + 0.1 * static_cast<double>(i) / static_cast<double>(count);
  return trials;
}

TimeStepChoice chosen_step(const Subject& s, double stiffer = 1.0) {
  return auto_time_step(s.trunk.model, s.scenario.parameters, s.scenario.activation, s.scenario.time,
                        stiffer);
}

VolumeCurve breath_on(const Subject& s, const TimeGrid& grid) {
  return simulate_volume(s.trunk, s.scenario.parameters, s.scenario.activation, grid);
}

/// One breath as a fit simulates it: the time loop, and the lung volume at every step.
Case breath(const Subject& s, const TimeGrid& grid) {
  return {[=] { breath_on(s, grid); },
          [=] { return fmt::format(R"(, "steps": {}, "dt_ms": {})", grid.steps(), 1e3 * grid.dt_s); }};
}

/// How far the enclosed volume is from what is asked for, over a whole breath; and the curve at the chosen
/// step from the one at a quarter of a millisecond, in percent of the tidal volume.
Case accuracy(const Subject& s) {
  return {[] {},
          [=] {
            const BreathRun run = run_breath(s.trunk, s.scenario, 0);
            const TimeGrid fine{0.25e-3, s.scenario.time.duration_s}, chosen = chosen_step(s).grid;
            const VolumeCurve exact = breath_on(s, fine), curve = breath_on(s, chosen);
            double apart = 0.0, highest = 0.0;
            for (std::size_t i = 0; i < curve.delta_v.size(); ++i) {
              const auto same_time =
                  static_cast<std::size_t>(std::lround(static_cast<double>(i) * chosen.dt_s / fine.dt_s));
              if (same_time >= exact.delta_v.size()) break;
              apart = std::max(apart, std::abs(curve.delta_v[i] - exact.delta_v[same_time]));
              highest = std::max(highest, exact.delta_v[same_time]);
            }
            return fmt::format(R"(, "volume_error": {:.3g}, "auto_delta_v_error_percent": {:.3g})",
                               run.max_relative_volume_error, 100.0 * apart / highest);
          }};
}

/// Different breaths on all cores, in lanes.
Case batch(const Subject& s, const TimeGrid& grid) {
  const std::size_t lanes = batch_lanes(), parts = 2 * std::max(1u, std::thread::hardware_concurrency());
  const Trials trials = different(s.scenario, lanes * parts);
  return {[=] {
            std::vector<std::size_t> items(parts);
            std::iota(items.begin(), items.end(), std::size_t{0});
            work_off<std::size_t>(
                items, 0, {},
                [&](std::size_t i) {
                  return simulate_volumes(s.trunk, std::span(trials).subspan(i * lanes, lanes), grid).size();
                },
                [](std::size_t) {});
          },
          [=] { return fmt::format(R"(, "breaths": {})", trials.size()); }};
}

/// k_elasticity and k_muscle of a breath made by the simulator itself, from a start off by 40 and 30 %, by
/// the default search.
Case fit(const Subject& s, const TimeGrid& grid) {
  MeasuredCurve measured;
  const VolumeCurve truth = breath_on(s, {0.5e-3, grid.duration_s});
  for (int i = 0; i <= 150; ++i) measured.time_s.push_back(grid.duration_s * i / 150);
  const Eigen::VectorXd seen = sampled(truth.delta_v, 0.5e-3, measured.time_s);
  measured.delta_v.assign(seen.data(), seen.data() + seen.size());
  Candidate start{s.scenario.parameters, s.scenario.activation};
  start.parameters.elasticity *= 1.4;
  start.parameters.muscle *= 0.7;
  EstimationOptions options;
  options.search.coordinate_tolerance = 1e-6;
  options.profiles = false;
  options.surface_points = 0;
  const auto result = std::make_shared<Estimation>();
  const TrunkAsCompartment compartment = as_compartment(measure_recoil(s.trunk.model, start.parameters));
  return {
      [=] {
        Ledger ledger;
        const SearchSpace space({"k_elasticity", "k_muscle"}, start);
        *result = estimate({s.trunk, grid, space, measured, compartment, start.parameters}, options, ledger);
      },
      [=] {
        return fmt::format(
            R"(, "evaluations": {}, "simulations": {}, "converged": {}, "relative_error": {:.3g})",
            result->search.evaluations, result->simulated, result->search.converged,
            std::abs(result->best.parameters.elasticity / s.scenario.parameters.elasticity - 1.0));
      }};
}

/// 200 steps at rest and a little later, of a mesh that fine; the time step goes down with its particles'
/// mass.
Case steps_of_mesh(int resolution) {
  const Subject s = subject("healthy_no_lung", resolution);
  const double stable_s = stable_time_step(s.trunk.model, s.scenario.parameters);
  const double dt_s = std::min(1e-3, 0.5 * stable_s);
  const TimeGrid grid{dt_s, 200 * dt_s};
  return {[=] { breath_on(s, grid); },
          [=] {
            return fmt::format(R"(, "steps": {}, "particles": {})", grid.steps(), s.trunk.model.particles());
          }};
}

const Kernel& kernel_named(const std::string& name) {
  for (const Kernel* k : kernels())
    if (name == k->instruction_set) return *k;
  throw InputError({}, "this machine has no kernel '" + name + "'", "one that it can run");
}

Case one_in(const Kernel& kernel, const Subject& s) {
  return {[=, &kernel] {
    const Trials trials = different(s.scenario, 1);
    VolumeCurve curve;
    kernel.volume_curve(s.trunk.model, trials, s.scenario.time, {&curve, 1});
  }};
}

Case lanes_in(const Kernel& kernel, const Subject& s) {
  const Trials trials = different(s.scenario, static_cast<std::size_t>(kernel.lanes));
  return {[=, &kernel] {
            std::vector<VolumeCurve> curves(trials.size());
            kernel.volume_curves(s.trunk.model, trials, s.scenario.time, curves);
          },
          [=] { return fmt::format(R"(, "breaths": {})", trials.size()); }};
}

Case derivatives_in(const Kernel& kernel, const Subject& s) {
  Trials directions(static_cast<std::size_t>(kernel.tangents), no_change());
  for (std::size_t i = 0; i < directions.size(); ++i) *numbers(directions[i])[i] = 1.0;
  return {[=, &kernel] {
            VolumeCurve curve;
            std::vector<BreathCurves> along(directions.size());
            kernel.volume_derivatives(s.trunk.model, {s.scenario.parameters, s.scenario.activation},
                                      directions, s.scenario.time, curve, along);
          },
          [=] { return fmt::format(R"(, "directions": {})", directions.size()); }};
}

/// A case by its name: a word and, for some, what it is about.
Case made(const std::string& name) {
  std::istringstream words(name);
  std::string what, which;
  words >> what;
  std::getline(words >> std::ws, which);
  const auto about = [&] { return subject(which.empty() ? "healthy" : which); };
  if (what == "breath") return breath(about(), about().scenario.time);
  if (what == "auto_breath") return breath(about(), chosen_step(about()).grid);
  if (what == "air") return breath(breathing_air(true), {});
  if (what == "no_air") return breath(breathing_air(false), {});
  if (what == "accuracy") return accuracy(about());
  if (what == "batch") return batch(about(), about().scenario.time);
  if (what == "auto_batch") return batch(about(), chosen_step(about()).grid);
  if (what == "fit") return fit(about(), about().scenario.time);
  if (what == "auto_fit") return fit(about(), chosen_step(about(), stiffer_in_searches).grid);
  if (what == "mesh") return steps_of_mesh(std::stoi(which));
  if (what == "one") return one_in(kernel_named(which), subject("healthy_no_lung"));
  if (what == "lanes") return lanes_in(kernel_named(which), subject("healthy_no_lung"));
  if (what == "derivatives") return derivatives_in(kernel_named(which), subject("healthy_no_lung"));
  throw InputError(
      {}, "there is no case '" + name + "'",
      "air, no_air, breath, auto_breath, accuracy, batch, auto_batch, fit or auto_fit [SCENARIO], "
      "mesh RESOLUTION, or one, lanes or derivatives KERNEL");
}

std::string kernel_names() {
  std::string names;
  for (const Kernel* k : kernels())
    names += fmt::format(R"({}"{}")", names.empty() ? "" : ", ", k->instruction_set);
  return names;
}

void answer(const std::string& name) {
  static std::map<std::string, Case> cases;  // made once: what is timed is the work alone
  if (name == "kernels") {
    std::cout << fmt::format(R"({{"kernels": [{}]}})", kernel_names()) << std::endl;
    return;
  }
  if (!cases.contains(name)) cases.emplace(name, made(name));
  const Case& found = cases.at(name);
  const auto start = std::chrono::steady_clock::now();
  found.work();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  std::cout << fmt::format(R"({{"ms": {:.6g}{}}})", taken.count(), found.remark()) << std::endl;
}

}  // namespace

int main(int argc, char** argv) try {
  for (int i = 1; i < argc; ++i) answer(argv[i]);
  if (argc == 1)
    for (std::string name; std::getline(std::cin, name);) answer(name);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "trunk_bench: {}\n", error.what());
  return 2;
}
