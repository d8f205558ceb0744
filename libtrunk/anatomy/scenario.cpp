#include "anatomy/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "anatomy/template_mesh.hpp"
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

}  // namespace

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
  Mistakes mistakes;
  for (const RegionLoad& load : s.loads) mistakes.gather([&] { apply(load, trunk); });
  mistakes.settle();
  drop_supports_of_held_particles(trunk.model);
  require_valid(trunk.model);
  return trunk;
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
  const double steps = s.time.duration_s / s.time.dt_s;
  if (!(steps >= 1.0 && steps <= 1e7))
    throw InputError({},
                     fmt::format("a duration of {:.4g} s at {:.4g} ms makes {:.3g} steps", s.time.duration_s,
                                 ms_per_s * s.time.dt_s, steps),
                     "1 to 1e7");
}

}  // namespace trunk
