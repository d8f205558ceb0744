#include "anatomy/breath_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace trunk {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double relative_volume_error(const Model& model, const State<double>& state) {
  const double fraction = model.abdomen.target.empty() ? 1.0 : model.abdomen.target(state.time_s);
  const double volume = enclosed_volume<double>(model.abdomen.triangles, state.position);
  return std::abs(volume / (fraction * model.abdomen.rest) - 1.0);
}

std::vector<BreathRun::Touch> touches(const State<double>& state) {
  using enum BreathRun::Touch;
  std::vector<BreathRun::Touch> result;
  for (const auto& contact : state.contact)
    result.push_back(!contact.touching ? none : contact.sticking ? sticks : slides);
  return result;
}

/// Triangles whose normal has turned by more than a right angle.
int flipped(std::span<const Triangle> triangles, std::span<const Vec3d> before,
            std::span<const Vec3d> after) {
  const auto normal = [](const Triangle& t, std::span<const Vec3d> x) {
    const auto at = [&](std::size_t corner) { return x[static_cast<std::size_t>(t[corner])]; };
    return cross(at(1) - at(0), at(2) - at(0));
  };
  return static_cast<int>(std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return dot(normal(t, before), normal(t, after)) < 0.0;
  }));
}

}  // namespace

BreathRun run_breath(const Trunk& trunk, const Scenario& scenario, int frame_every) {
  const Model& model = trunk.model;
  const double start_volume = enclosed_volume<double>(model.lung, model.rest);
  double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
  std::vector<Vec3d> at_lowest = model.rest;
  BreathRun run;
  run.end_inspiration = model.rest;

  const auto observe = [&](int step, double activation, const State<double>& state,
                           const StepReport<double>& report) {
    const double volume = enclosed_volume<double>(model.lung, state.position);
    run.time_s.push_back(state.time_s);
    run.delta_v.push_back(volume - start_volume);
    run.activation.push_back(activation);
    run.pressure_Pa.push_back(report.pressure_Pa);
    run.max_relative_volume_error =
        std::max(run.max_relative_volume_error, relative_volume_error(model, state));
    if (volume > highest) {
      highest = volume;
      run.end_inspiration = state.position;
    }
    if (volume < lowest) {
      lowest = volume;
      at_lowest = state.position;
    }
    if (frame_every > 0 && step % frame_every == 0)
      run.frames.push_back({step, state.position, state.velocity, touches(state)});
  };
  const auto start = std::chrono::steady_clock::now();
  run.summary = simulate(model, scenario.parameters, scenario.activation, scenario.time, observe);
  run.wall_s = seconds_since(start);
  require_lung(lowest, run.summary);
  run.flipped_triangles = std::max(flipped(model.lung, model.rest, run.end_inspiration),
                                   flipped(model.lung, model.rest, at_lowest));
  run.measures = measures_between(shape_of(trunk, model.rest), shape_of(trunk, run.end_inspiration));
  return run;
}

VolumeCurve simulate_volume(const Trunk& trunk, const Parameters<double>& parameters,
                            const BreathActivation<double>& activation, const TimeGrid& grid) {
  const Trial<double> trial{parameters, activation};
  VolumeCurve curve;
  kernel().volume_curve(trunk.model, {&trial, 1}, grid, {&curve, 1});
  return curve;
}

std::size_t batch_lanes() noexcept {
  return static_cast<std::size_t>(kernel().lanes);
}

std::vector<VolumeCurve> simulate_volumes(const Trunk& trunk, std::span<const Trial<double>> trials,
                                          const TimeGrid& grid) {
  constexpr std::size_t worth_lanes = 3;  // a step of all lanes costs that of 2 to 3 simulations
  const std::size_t lanes = batch_lanes();
  std::vector<VolumeCurve> curves(trials.size());
  for (std::size_t first = 0; first < trials.size();) {
    const std::size_t left = trials.size() - first;
    const bool together = left >= std::min(lanes, worth_lanes);
    const std::size_t count = together ? std::min(lanes, left) : 1;
    const auto run = together ? kernel().volume_curves : kernel().volume_curve;
    run(trunk.model, trials.subspan(first, count), grid, std::span(curves).subspan(first, count));
    first += count;
  }
  return curves;
}

VolumeDerivatives simulate_volume_derivatives(const Trunk& trunk, const Trial<double>& trial,
                                              std::span<const Trial<double>> directions,
                                              const TimeGrid& grid) {
  const auto at_once = static_cast<std::size_t>(kernel().tangents);
  VolumeDerivatives result{{}, std::vector<std::vector<double>>(directions.size())};
  std::size_t first = 0;
  do {
    const std::size_t count = std::min(at_once, directions.size() - first);
    kernel().volume_derivatives(trunk.model, trial, directions.subspan(first, count), grid, result.curve,
                                std::span(result.along).subspan(first, count));
    first += count;
  } while (first < directions.size());
  return result;
}

}  // namespace trunk
