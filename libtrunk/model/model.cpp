#include "model/model.hpp"

#include <fmt/format.h>

#include "errors/input_error.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

void require(bool condition, const std::string& text) {
  if (!condition) throw InputError(text);
}

bool finite(const Vec3d& a) {
  return std::isfinite(a.x()) && std::isfinite(a.y()) && std::isfinite(a.z());
}

void require_particles(const Model& m) {
  const std::size_t n = m.particles();
  require(n > 0, "the model has no particle");
  require(m.mass.size() == n && m.damping_weight.size() == n && m.mobility.size() == n,
          fmt::format("the model has {} positions, {} masses, {} damping weights and {} mobilities; expected "
                      "one of each a particle",
                      n, m.mass.size(), m.damping_weight.size(), m.mobility.size()));
  for (std::size_t i = 0; i < n; ++i) {
    require(finite(m.rest[i]), fmt::format("particle {}: its rest position is not finite", i));
    require(std::isfinite(m.mass[i]) && m.mass[i] > 0,
            fmt::format("particle {}: found a mass of {} kg, expected more than 0", i, m.mass[i]));
    require(
        std::isfinite(m.damping_weight[i]) && m.damping_weight[i] >= 0,
        fmt::format("particle {}: found a damping weight of {}, expected 0 or more", i, m.damping_weight[i]));
  }
}

void require_shape_memory(const Model& m) {
  const ShapeMemory& s = m.shape_memory;
  const std::size_t rings = s.rings.size();
  require(s.rest_offset.size() == rings && s.stiffness_weight.size() == rings &&
              s.abdominal_share.size() == rings,
          "the shape memory's arrays differ in length");
  for (std::size_t r = 0; r < rings; ++r) {
    require(finite(s.rest_offset[r]),
            fmt::format("particle {}: its neighbours enclose no area, so it has no local frame; expected a "
                        "surface without flat or repeated triangles",
                        s.rings.vertex[r]));
    require(std::isfinite(s.stiffness_weight[r]) && s.stiffness_weight[r] >= 0,
            fmt::format("particle {}: found a stiffness factor of {}, expected 0 or more", s.rings.vertex[r],
                        s.stiffness_weight[r]));
  }
}

void require_references(const Model& m) {
  const auto exists = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < m.particles(); };
  for (const Fibre& f : m.fibres) {
    require(exists(f.insertion) && exists(f.origin) && f.insertion != f.origin,
            fmt::format("fibre {}-{}: expected two different particles that exist", f.insertion, f.origin));
    require(std::isfinite(f.activity) && f.activity >= 0,
            fmt::format("fibre {}-{}: found an activity of {}, expected 0 or more", f.insertion, f.origin,
                        f.activity));
  }
  for (const Support& s : m.supports)
    require(
        exists(s.particle) && s.body >= 0 && static_cast<std::size_t>(s.body) < m.bodies.size() &&
            m.bodies[static_cast<std::size_t>(s.body)].motion != RigidBody::Motion::free,
        fmt::format("particle {} is supported by a body that does not exist or is free; expected a fixed or "
                    "driven one",
                    s.particle));
  for (const Support& s : m.supports)
    require(finite(s.point) && finite(s.normal) && finite(s.curvature[0]) && finite(s.curvature[1]) &&
                finite(s.curvature[2]),
            fmt::format("the rigid surface at particle {} has no direction; expected muscle lines apart from "
                        "each other",
                        s.particle));
  for (const MembraneEdge& e : m.membrane)
    require(exists(e.a) && exists(e.b) && e.rest_length > 0 && e.stiffness >= 0,
            fmt::format("membrane edge {}-{}: expected two particles apart and a stiffness of 0 or more", e.a,
                        e.b));
  for (const PressureLoad& p : m.pressures)
    for (const Triangle& t : p.triangles)
      require(exists(t[0]) && exists(t[1]) && exists(t[2]), "a pressure acts on particles that do not exist");
  require(std::isfinite(m.friction) && m.friction >= 0,
          fmt::format("found a friction coefficient of {}, expected 0 or more", m.friction));
  for (const FocalForce& f : m.focal_forces)
    require(exists(f.particle), fmt::format("a force acts on particle {}, which does not exist", f.particle));
  for (const ImposedDisplacement& d : m.imposed_displacements)
    require(exists(d.particle),
            fmt::format("a displacement acts on particle {}, which does not exist", d.particle));
}

}  // namespace

std::vector<bool> pushed_particles(const Model& model) {
  std::vector<bool> pushed;
  for (const Vec3d& free_axes : model.mobility) pushed.push_back(dot(free_axes, free_axes) > 0.0);
  for (const RigidBody& body : model.bodies)
    if (body.motion == RigidBody::Motion::free)
      for (const int i : body.particles) pushed[static_cast<std::size_t>(i)] = true;
  return pushed;
}

std::vector<bool> moving_particles(const Model& model) {
  std::vector<bool> moving = pushed_particles(model);
  for (const ImposedDisplacement& imposed : model.imposed_displacements)
    moving[static_cast<std::size_t>(imposed.particle)] = true;
  for (const RigidBody& body : model.bodies)
    if (body.motion == RigidBody::Motion::driven)
      for (const int i : body.particles) moving[static_cast<std::size_t>(i)] = true;
  return moving;
}

std::vector<HalfOpenRange> ranges(const std::vector<bool>& mask) {
  std::vector<HalfOpenRange> found;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    if (found.empty() || found.back().last != i) found.push_back({i, i});
    ++found.back().last;
  }
  return found;
}

MovingAndStill by_motion(const RingTable& fans, const Model& model) {
  const std::vector<bool> moving = moving_particles(model);
  const auto moves = [&](int centre, auto polygon) { return any_of_ring(moving, centre, polygon); };
  return {only_those(fans, moves), only_those(fans, std::not_fn(moves))};
}

HeldVolume held_volume(const Surface& surface, std::span<const Vec3d> rest) {
  const std::span<const Triangle> triangles = surface.triangles();
  return {{triangles.begin(), triangles.end()},
          ring_table(surface),
          fans(triangles),
          enclosed_volume<double>(triangles, rest),
          {}};
}

void require_valid(const Model& model) {
  require_particles(model);
  require_shape_memory(model);
  require_references(model);
  require(model.abdomen.rest > 0,
          fmt::format("the abdominal compartment encloses {:.4g} ml at rest; expected a positive volume "
                      "(triangles counter-clockwise seen from outside)",
                      ml_per_m3 * model.abdomen.rest));
  const double lung = volume_of_fans<double>(model.lung_fans, model.rest);
  require(lung > 0,
          fmt::format("the lung encloses {:.4g} ml at rest; expected a positive volume", ml_per_m3 * lung));
}

}  // namespace trunk
