#include "model/model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "errors/input_error.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

void require(bool condition, const std::string& found, const std::string& expected = "") {
  if (!condition) throw InputError({}, found, expected);
}

bool exists(int particle, const Model& m) {
  return particle >= 0 && static_cast<std::size_t>(particle) < m.particles();
}

bool finite(const Vec3d& a) {
  return std::isfinite(a.x()) && std::isfinite(a.y()) && std::isfinite(a.z());
}

void require_particles(const Model& m) {
  const std::size_t n = m.particles();
  require(n > 0, "the model has no particle");
  require(m.mass.size() == n && m.damping_weight.size() == n && m.mobility.size() == n,
          fmt::format("the model has {} positions, {} masses, {} damping weights and {} mobilities", n,
                      m.mass.size(), m.damping_weight.size(), m.mobility.size()),
          "one of each a particle");
  for (std::size_t i = 0; i < n; ++i) {
    require(finite(m.rest[i]), fmt::format("particle {}: its rest position is not finite", i));
    require(std::isfinite(m.mass[i]) && m.mass[i] > 0,
            fmt::format("particle {} has a mass of {} kg", i, m.mass[i]), "more than 0");
    require(std::isfinite(m.damping_weight[i]) && m.damping_weight[i] >= 0,
            fmt::format("particle {} has a damping weight of {}", i, m.damping_weight[i]), "0 or more");
  }
}

void require_shape_memory(const Model& m) {
  const ShapeMemory& s = m.shape_memory;
  const std::size_t rings = s.rings.size();
  require(s.rest_offset.size() == rings && s.stiffness_weight.size() == rings &&
              s.abdominal_share.size() == rings,
          "the shape memory's arrays differ in length");
  require(s.extra_weight.empty() || (s.extra_weight.size() == s.rings.neighbour.size() &&
                                     s.extra_received.size() == s.receiving.neighbour.size()),
          "the shape memory's weights are not one for each neighbour");
  require(s.extra_weight.empty() || s.reaction == Reaction::variational,
          "the published reaction is shared equally, so neighbours cannot have weights");
  for (std::size_t r = 0; r < rings; ++r) {
    require(finite(s.rest_offset[r]),
            fmt::format("particle {}: its neighbours enclose no area, so it has no local frame",
                        s.rings.vertex[r]),
            "a surface without flat or repeated triangles");
    require(std::isfinite(s.stiffness_weight[r]) && s.stiffness_weight[r] >= 0,
            fmt::format("particle {} has a stiffness factor of {}", s.rings.vertex[r], s.stiffness_weight[r]),
            "0 or more");
  }
}

void require_fibres(const Model& m) {
  for (const Fibre& f : m.fibres) {
    require(exists(f.insertion, m) && exists(f.origin, m) && f.insertion != f.origin,
            fmt::format("fibre {}-{} does not join two particles", f.insertion, f.origin),
            "two different particles that exist");
    require(std::isfinite(f.activity) && f.activity >= 0,
            fmt::format("fibre {}-{} has an activity of {}", f.insertion, f.origin, f.activity), "0 or more");
  }
}

void require_supports(const Model& m) {
  for (const Support& s : m.supports) {
    require(exists(s.particle, m) && s.body >= 0 && static_cast<std::size_t>(s.body) < m.bodies.size() &&
                m.bodies[static_cast<std::size_t>(s.body)].motion != RigidBody::Motion::free,
            fmt::format("particle {} is supported by a body that does not exist or is free", s.particle),
            "a fixed or driven one");
    require(finite(s.point) && finite(s.normal) && finite(s.curvature[0]) && finite(s.curvature[1]) &&
                finite(s.curvature[2]),
            fmt::format("the rigid surface at particle {} has no direction", s.particle),
            "muscle lines apart from each other");
  }
  require(std::isfinite(m.friction) && m.friction >= 0,
          fmt::format("the friction coefficient is {}", m.friction), "0 or more");
}

/// The flow that a free body makes is not part of the implicit resistance.
void require_pleura(const Model& m) {
  if (!m.pleura) return;
  require(m.abdomen.rings.size() > 0, "a lung acts on a trunk without a held volume", "an abdomen");
  require(std::isfinite(m.pleura->tube_resistance) && m.pleura->tube_resistance >= 0,
          fmt::format("the tube has a resistance of {} Pa s/m3", m.pleura->tube_resistance), "0 or more");
  for (const RigidBody& body : m.bodies)
    if (body.motion == RigidBody::Motion::free)
      for (const int i : body.particles)
        require(
            std::find(m.lung_rings.vertex.begin(), m.lung_rings.vertex.end(), i) == m.lung_rings.vertex.end(),
            fmt::format("the free rigid part '{}' carries particle {}, on which the lung acts", body.name, i),
            "a fixed or driven part, or a trunk without [lung] and [airway]");
}

void require_loads(const Model& m) {
  for (const MembraneEdge& e : m.membrane)
    require(exists(e.a, m) && exists(e.b, m) && e.rest_length > 0 && e.stiffness >= 0,
            fmt::format("membrane edge {}-{} has a length of {} m and a stiffness of {} N/m", e.a, e.b,
                        e.rest_length, e.stiffness),
            "two particles apart and a stiffness of 0 or more");
  for (const PressureLoad& p : m.pressures)
    for (const Triangle& t : p.triangles)
      require(exists(t[0], m) && exists(t[1], m) && exists(t[2], m),
              "a pressure acts on particles that do not exist");
  for (const FocalForce& f : m.focal_forces)
    require(exists(f.particle, m),
            fmt::format("a force acts on particle {}, which does not exist", f.particle));
  for (const ImposedDisplacement& d : m.imposed_displacements)
    require(exists(d.particle, m),
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
  require_fibres(model);
  require_supports(model);
  require_loads(model);
  require_pleura(model);
  require(model.abdomen.rest > 0,
          fmt::format("the abdominal compartment encloses {:.4g} ml at rest", ml_per_m3 * model.abdomen.rest),
          "a positive volume (triangles counter-clockwise seen from outside)");
  const double lung = volume_of_fans<double>(model.lung_fans, model.rest);
  require(lung > 0, fmt::format("the lung encloses {:.4g} ml at rest", ml_per_m3 * lung),
          "a positive volume (triangles counter-clockwise seen from outside)");
}

}  // namespace trunk
