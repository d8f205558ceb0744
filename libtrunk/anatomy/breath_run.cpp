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

std::vector<BreathRun::Touch> touches(const State<double>& state) {
  using enum BreathRun::Touch;
  std::vector<BreathRun::Touch> result;
  for (const auto& contact : state.contact)
    result.push_back(!contact.touching ? none : contact.sticking ? sticks : slides);
  return result;
}

/// Returns the number of triangles whose normal has turned by more than a right angle.
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

/// Calls run(first, count) for parts of all simulations: as many as there are lanes, or one where that is
/// faster.
template <class RunPart>
void in_parts(std::size_t all, const RunPart& run) {
  constexpr std::size_t worth_lanes = 3;  // a step of all lanes costs as much as 2 to 3 single steps
  const std::size_t lanes = batch_lanes();
  for (std::size_t first = 0; first < all;) {
    const std::size_t left = all - first;
    const std::size_t count = left >= std::min(lanes, worth_lanes) ? std::min(lanes, left) : 1;
    run(first, count);
    first += count;
  }
}

std::vector<Vec3d> velocities(const State<double>& state, double dt_s) {
  std::vector<Vec3d> all;
  for (std::size_t i = 0; i < state.position.size(); ++i) all.push_back(velocity(state, i, dt_s));
  return all;
}

BreathSummary summary_of(const Trunk& trunk, BreathCourse course) {
  const Model& model = trunk.model;
  BreathSummary s;
  s.ending = std::move(course.curve.ending);
  s.delta_v = std::move(course.curve.delta_v);
  s.above_relaxation = course.curve.above_relaxation;
  s.measures = measures_between(shape_of(trunk, course.at_start), shape_of(trunk, course.at_highest));
  s.peak_pressure_Pa = course.peak_pressure_Pa;
  s.gastric_swing_Pa = course.gastric_swing_Pa;
  if (model.pleura) s.swings = course.swings;
  s.right_rise = course.right_rise_m;
  s.left_rise = course.left_rise_m;
  s.max_relative_volume_error = course.max_relative_volume_error;
  s.flipped_triangles = std::max(flipped(model.lung, model.rest, course.at_highest),
                                 flipped(model.lung, model.rest, course.at_lowest));
  return s;
}

/// Returns the kernel with the fewest tangents that still takes all directions at once. Half of the work is
/// in the values, and wider registers do not make that faster.
const Kernel& kernel_for(std::size_t directions) {
  for (const Kernel* k : kernels())
    if (static_cast<std::size_t>(k->tangents) >= directions) return *k;
  return kernel();
}

}  // namespace

BreathRun run_breath(const Trunk& trunk, const Scenario& scenario, int frame_every,
                     const WhileSimulated& check) {
  BreathWatch<double> watch(trunk.model, scenario.time.steps(), check);
  BreathRun run;
  const auto observe = [&](int step, double activation, const State<double>& state,
                           const StepReport<double>& report) {
    watch(step, state, report);
    run.time_s.push_back(state.time_s);
    run.activation.push_back(activation);
    run.pressure_Pa.push_back(report.pressure_Pa);
    if (trunk.model.pleura) run.pleural_pressure_Pa.push_back(report.pleural_pressure_Pa);
    if (frame_every > 0 && step % frame_every == 0)
      run.frames.push_back({step, state.position, velocities(state, scenario.time.dt_s), touches(state)});
  };
  const auto start = std::chrono::steady_clock::now();
  Ending ending = simulate(trunk.model, scenario.parameters, scenario.activation, scenario.time, observe);
  run.wall_s = seconds_since(start);
  BreathCourse course = watch.course(std::move(ending), 0);
  run.start = course.at_start;
  run.end_inspiration = course.at_highest;
  static_cast<BreathSummary&>(run) = summary_of(trunk, std::move(course));
  return run;
}

std::vector<BreathSummary> summarise_breaths(const Trunk& trunk, std::span<const Trial<double>> trials,
                                             const TimeGrid& grid, const WhileSimulated& check) {
  std::vector<BreathSummary> summaries;
  std::vector<BreathCourse> courses(batch_lanes());
  in_parts(trials.size(), [&](std::size_t first, std::size_t count) {
    const auto run = count > 1 ? kernel().breath_courses : kernel().breath_course;
    run(trunk.model, trials.subspan(first, count), grid, check, std::span(courses).first(count));
    for (std::size_t i = 0; i < count; ++i) summaries.push_back(summary_of(trunk, std::move(courses[i])));
  });
  return summaries;
}

VolumeCurve simulate_volume(const Trunk& trunk, const Parameters<double>& parameters,
                            const BreathActivation<double>& activation, const TimeGrid& grid) {
  const Trial<double> trial{parameters, activation};
  VolumeCurve curve;
  kernel().volume_curve(trunk.model, {&trial, 1}, grid, {&curve, 1});
  return curve;
}

double end_expiratory_volume(const Trunk& trunk, const Scenario& s) {
  const double at_rest = shape_of(trunk, trunk.model.rest).lung_volume;
  if (s.time.start == Start::rest) return at_rest;
  return at_rest + simulate_volume(trunk, s.parameters, s.activation, s.time).above_relaxation;
}

std::size_t batch_lanes() noexcept {
  return static_cast<std::size_t>(kernel().lanes);
}

std::vector<VolumeCurve> simulate_volumes(const Trunk& trunk, std::span<const Trial<double>> trials,
                                          const TimeGrid& grid) {
  std::vector<VolumeCurve> curves(trials.size());
  in_parts(trials.size(), [&](std::size_t first, std::size_t count) {
    const auto run = count > 1 ? kernel().volume_curves : kernel().volume_curve;
    run(trunk.model, trials.subspan(first, count), grid, std::span(curves).subspan(first, count));
  });
  return curves;
}

VolumeDerivatives simulate_volume_derivatives(const Trunk& trunk, const Trial<double>& trial,
                                              std::span<const Trial<double>> directions,
                                              const TimeGrid& grid) {
  const Kernel& kernel = kernel_for(directions.size());
  const auto at_once = static_cast<std::size_t>(kernel.tangents);
  VolumeDerivatives result{{}, std::vector<BreathCurves>(directions.size()), {}};
  std::size_t first = 0;
  do {
    const std::size_t count = std::min(at_once, directions.size() - first);
    kernel.volume_derivatives(trunk.model, trial, directions.subspan(first, count), grid, result.curve,
                              std::span(result.along).subspan(first, count));
    first += count;
  } while (first < directions.size());
  for (BreathCurves& derivative : result.along) {
    result.above_relaxation.push_back(take_first_off(derivative.delta_v));
    for (std::size_t k = 1; k < all_curves.size(); ++k) take_first_off(derivative.*all_curves[k]);
  }
  return result;
}

}  // namespace trunk
