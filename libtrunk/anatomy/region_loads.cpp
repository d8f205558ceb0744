#include "anatomy/region_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace trunk {
namespace {

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Returns the triangles of the trunk with all corners selected. Those of the dome face as in the abdomen.
std::vector<Triangle> triangles_within(const TrunkMesh& mesh, const std::set<int>& selected) {
  std::vector<Triangle> within;
  std::set<Triangle> seen;
  for (const auto* surface : {&mesh.abdomen, &mesh.lung})
    for (const Triangle& t : *surface)
      if (std::all_of(t.begin(), t.end(), [&](int i) { return selected.contains(i); }) &&
          seen.insert(sorted(t)).second)
        within.push_back(t);
  return within;
}

bool carried(const Model& model, int particle) {
  return std::any_of(model.bodies.begin(), model.bodies.end(), [&](const RigidBody& body) {
    return std::find(body.particles.begin(), body.particles.end(), particle) != body.particles.end() &&
           body.motion != RigidBody::Motion::fixed;
  });
}

void impose(const RegionLoad& load, int particle, Model& model) {
  if (carried(model, particle))
    throw InputError(
        load.at,
        fmt::format("particle {} is carried by a moving rigid part, so no displacement can be imposed on it",
                    particle),
        "another region, or another motion of the part");
  model.imposed_displacements.push_back({particle, load.axes, load.direction, load.magnitude});
  Vec3d& mobility = model.mobility[static_cast<std::size_t>(particle)];
  mobility = hadamard(mobility, Vec3d(1.0, 1.0, 1.0) - load.axes);
}

/// Adds a third of each triangle's force at each of its corners.
void add_traction(const RegionLoad& load, const std::vector<Triangle>& triangles, Model& model) {
  for (const Triangle& t : triangles) {
    const auto at = [&](std::size_t corner) { return model.rest[static_cast<std::size_t>(t[corner])]; };
    const double area = 0.5 * norm(cross(at(1) - at(0), at(2) - at(0)));
    for (int i : t) model.focal_forces.push_back({i, (area / 3.0) * load.direction, load.magnitude});
  }
}

}  // namespace

void apply(const RegionLoad& load, Trunk& trunk) {
  Model& model = trunk.model;
  const std::vector<int> particles = selected_particles(trunk.mesh, load.region, load.at);
  if (load.kind == RegionLoad::Kind::pressure) {
    const auto triangles = triangles_within(trunk.mesh, {particles.begin(), particles.end()});
    if (triangles.empty())
      throw InputError(
          load.at, fmt::format("no triangle has all its corners in '{}', so a pressure has nothing to act on",
                               load.region));
    if (dot(load.direction, load.direction) == 0.0)
      model.pressures.push_back({triangles, load.magnitude});
    else
      add_traction(load, triangles, model);
    return;
  }
  for (int i : particles) switch (load.kind) {
      case RegionLoad::Kind::force:
        model.focal_forces.push_back({i, load.direction, load.magnitude});
        break;
      case RegionLoad::Kind::acceleration:
        model.focal_forces.push_back(
            {i, model.mass[static_cast<std::size_t>(i)] * load.direction, load.magnitude});
        break;
      default:
        impose(load, i, model);
    }
}

}  // namespace trunk
