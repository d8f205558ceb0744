#include "anatomy/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "anatomy/template_mesh.hpp"
#include "dynamics/recoil.hpp"
#include "dynamics/stability.hpp"
#include "errors/input_error.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

/// Removes the supports of particles that are held or driven, since the rib cage cannot push them back.
void drop_supports_of_held_particles(Model& model) {
  std::erase_if(model.supports, [&](const Support& s) {
    const Vec3d& m = model.mobility[static_cast<std::size_t>(s.particle)];
    return m.x() * m.y() * m.z() == 0.0;
  });
}

/// Throws InputError unless a course ends a breath with the value with which it began it.
void require_repeating(const PiecewiseLinear& course, double breath_s, const Place& at) {
  if (course.empty()) return;
  constexpr double round_off = 1e-9;
  const double first = course(0.0), last = course(breath_s);
  double largest = 0.0;
  for (const auto& event : course.events()) largest = std::max(largest, std::abs(event.value));
  if (std::abs(last - first) > round_off * largest)
    throw InputError(at,
                     "its course ends the breath with another value than it begins with, so it cannot repeat",
                     "the same value at 0 s and at the end of the breath", "start = \"rest\" in [time]");
}

}  // namespace

void require_repeating(const Scenario& s) {
  if (s.time.start == Start::rest) return;
  const double breath_s = s.time.duration_s, cycles = breath_s / s.activation.period_s;
  const auto varies = [](const PiecewiseLinear& course) { return course.events().size() > 1; };
  Mistakes mistakes;
  bool varying = varies(s.abdominal_volume) || varies(s.pleura.airway_pressure);
  mistakes.gather([&] { require_repeating(s.abdominal_volume, breath_s, {"abdominal_volume_fraction"}); });
  mistakes.gather([&] { require_repeating(s.pleura.airway_pressure, breath_s, {"airway.pressure_cmH2O"}); });
  for (const RegionLoad& load : s.loads) {
    varying = varying || varies(load.magnitude);
    mistakes.gather([&] { require_repeating(load.magnitude, breath_s, load.at); });
  }
  for (const RigidPart& part : s.rigid)
    for (const PiecewiseLinear* course : {&part.imposed.angle, &part.imposed.shift}) {
      varying = varying || varies(*course);
      mistakes.gather([&] { require_repeating(*course, breath_s, part.at); });
    }
  if (varying && s.activation.period_s > 0.0 && std::abs(cycles - std::round(cycles)) > 1e-9 * cycles)
    mistakes.gather([&] {
      throw InputError({},
                       fmt::format("the activation repeats every {:g} s, but loads and rigid parts repeat "
                                   "every {:g} s",
                                   s.activation.period_s, breath_s),
                       "a time.duration_s of whole periods");
    });
  mistakes.settle();
}

int frame_stride(const Scenario& s) {
  if (s.frame_every_s == 0.0) return 0;
  return std::max(1, static_cast<int>(std::lround(s.frame_every_s / s.time.dt_s)));
}

TrunkMesh mesh_of(const Scenario& s) {
  return s.mesh ? *s.mesh : make_template_mesh(s.geometry);
}

Trunk make_trunk(const Scenario& s) {
  Trunk trunk = make_trunk(mesh_of(s), s.tissue, s.reaction, s.rigid);
  trunk.model.gravity = s.gravity;
  trunk.model.abdomen.target = s.abdominal_volume;
  if (s.lung_acts) trunk.model.pleura = s.pleura;
  Mistakes mistakes;
  for (const RegionLoad& load : s.loads) mistakes.gather([&] { apply(load, trunk); });
  mistakes.settle();
  drop_supports_of_held_particles(trunk.model);
  require_valid(trunk.model);
  require_repeating(s);
  if (s.time.start == Start::periodic) trunk.model.recoil = measure_recoil_for_leads(trunk.model);
  return trunk;
}

std::optional<double> recoil_time_s(const Trunk& trunk, const Scenario& s) {
  Model model = trunk.model;
  for (Fibre& fibre : model.fibres)
    if (fibre.activity == 0.0) fibre.activity = 1.0;
  try {
    const double time_s = recoil_time_s(measure_recoil(model, s.parameters), s.parameters, model.pleura);
    return time_s > 0.0 ? std::optional(time_s) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void require_stable(const Scenario& s, const Trunk& trunk) {
  const double bound = stable_time_step(trunk.model, s.parameters, s.time.damping);
  if (!(s.time.dt_s < bound))
    throw InputError(
        {},
        fmt::format(
            "a time step of {:.4g} ms is unstable for k_elasticity {:.4g} N/m, k_muscle {:.4g} N/m and "
            "damping {:.4g} N s/m",
            ms_per_s * s.time.dt_s, s.parameters.elasticity, s.parameters.muscle, s.parameters.damping),
        fmt::format("less than {:.4g} ms", ms_per_s * bound), "lower time.dt_ms");
  require_memory(s, trunk);
  const double lead = s.time.start == Start::rest ? 0.0 : lead_s(trunk.model, s.parameters);
  const double steps = s.time.duration_s / s.time.dt_s, steps_before = lead / s.time.dt_s;
  if (!(steps >= 1.0 && steps + steps_before <= 1e7))
    throw InputError(
        {},
        fmt::format("a duration of {:.4g} s at {:.4g} ms makes {:.3g} steps", s.time.duration_s,
                    ms_per_s * s.time.dt_s, steps) +
            (lead > 0.0 ? fmt::format(", after {:.3g} in which breathing repeats", steps_before) : ""),
        "1 to 1e7");
}

void require_memory(const Scenario& s, const Trunk& trunk) {
  if (s.time.start == Start::rest) return;
  const double lead = lead_s(trunk.model, s.parameters);
  if (lead <= longest_lead_s) return;
  throw InputError(
      {},
      std::isfinite(lead)
          ? fmt::format("this trunk takes {:.3g} s to forget how it started, so its breathing cannot repeat",
                        lead)
          : "this trunk never forgets how it started, so its breathing cannot repeat",
      fmt::format("at most {:g} s", longest_lead_s),
      "raise k_elasticity, change the damping, or set start = \"rest\" in [time]");
}

}  // namespace trunk
