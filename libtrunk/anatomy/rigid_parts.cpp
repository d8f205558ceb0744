#include "anatomy/rigid_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// The place of a particle on the grid of muscle lines.
struct GridPlace {
  std::size_t line, row;
};

std::map<int, GridPlace> places_of(const TrunkMesh& mesh) {
  std::map<int, GridPlace> places;
  for (std::size_t line = 0; line < mesh.muscle_lines.size(); ++line)
    for (std::size_t row = 0; row <= mesh.apposition_top_row(); ++row)
      places[mesh.muscle_lines[line][row]] = {line, row};
  return places;
}

/// Returns the curvature of a curve through three points, 1/m, towards the side away from `normal`.
double curvature_of(const Vec3d& before, const Vec3d& at, const Vec3d& after, const Vec3d& normal) {
  const Vec3d half_chord = 0.5 * (after - before), sagitta = at - 0.5 * (before + after);
  return 2.0 * dot(sagitta, normal) / dot(half_chord, half_chord);
}

/// Returns the rib surface at a particle of the zone of apposition (our choice). It passes through the
/// particle's rest position, is tangent to the grid of the muscle lines, and is curved like the grid along
/// both of its directions. Let x' and x'' be the first and second central differences of rest positions, by
/// line and by row. The normal n is perpendicular to both x' and points outward. With e the tangent around
/// the trunk, the curvature along e is -x''.n / |x'|^2 by line, and along n x e it is the same by row. No
/// ribs are above the top row: there, x' by row is the difference downward, and the curvature by row is 0.
Support support_at(const TrunkMesh& mesh, int particle, const GridPlace& place, int body) {
  const auto& lines = mesh.muscle_lines;
  const std::size_t count = lines.size(), top = mesh.apposition_top_row();
  const auto at = [&](std::size_t line, std::size_t row) {
    return mesh.rest[static_cast<std::size_t>(lines[line % count][row])];
  };
  const auto [line, row] = place;
  const std::size_t above = std::min(row + 1, top);
  const Vec3d here = at(line, row), left = at(line + 1, row), right = at(line + count - 1, row);
  const Vec3d around = left - right, upward = at(line, above) - at(line, row - 1);
  const Vec3d area = cross(around, upward);
  const Vec3d normal = (1.0 / norm(area)) * area;
  Support support{particle, body, here, normal, {}};
  const auto bend_along = [&](const Vec3d& direction, double curvature) {
    const Vec3d unit = (1.0 / norm(direction)) * direction;
    const double component[3] = {unit.x(), unit.y(), unit.z()};
    for (int k = 0; k < 3; ++k) support.curvature[k] += (curvature * component[k]) * unit;
  };
  bend_along(around, curvature_of(right, here, left, normal));
  if (row < top)
    bend_along(cross(normal, around), curvature_of(at(line, row - 1), here, at(line, above), normal));
  return support;
}

std::vector<int> not_claimed(const TrunkMesh& mesh, const std::set<int>& claimed) {
  std::vector<int> left;
  for (const char* region : {"costal_insertion", "lung_wall", "lung_top"})
    for (int i : mesh.named(region))
      if (!claimed.contains(i)) left.push_back(i);
  return left;
}

RigidBody body_of(const TrunkMesh& mesh, const RigidPart& part) {
  RigidBody body;
  body.name = part.region;
  body.motion = part.motion;
  body.particles = selected_particles(mesh, part.region, part.at);
  body.imposed = part.imposed;
  return body;
}

/// A free body has no contact, so its particles could cross the ribs.
void require_free_parts_off(const std::map<int, int>& surface_of, const std::vector<RigidPart>& parts,
                            const Model& model) {
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (int i : model.bodies[part].particles)
      if (parts[part].motion == RigidBody::Motion::free && surface_of.contains(i))
        throw InputError(
            parts[part].at,
            fmt::format("the free rigid part '{}' carries particle {}, which slides along the ribs",
                        parts[part].region, i),
            "a part off the zone of apposition, or tissue.ribs = false");
}

}  // namespace

void add_rigid_parts(const TrunkMesh& mesh, const Tissue& tissue, const std::vector<RigidPart>& parts,
                     Model& model) {
  std::set<int> claimed;
  std::map<int, int> surface_of;  // particle -> body
  for (const RigidPart& part : parts) {
    const RigidBody body = body_of(mesh, part);
    claimed.insert(body.particles.begin(), body.particles.end());
    if (part.motion == RigidBody::Motion::free && !part.surface_for.empty())
      throw InputError(part.at, fmt::format("the rigid part '{}' is free and has a surface", part.region),
                       "a fixed or driven one");
    if (!part.surface_for.empty())
      for (int i : selected_particles(mesh, part.surface_for, part.at))
        if (!surface_of.emplace(i, static_cast<int>(model.bodies.size())).second)
          throw InputError(part.at, fmt::format("particle {} already slides along another rigid part", i),
                           "one");
    try {
      carry(body, model);
    } catch (const InputError& error) {
      Mistake mistake = error.mistake();
      mistake.at = part.at;
      throw InputError(std::move(mistake));
    }
  }
  if (tissue.ribs) {
    for (int i : mesh.named("zone_of_apposition"))
      surface_of.emplace(i, static_cast<int>(model.bodies.size()));
    RigidBody rib_cage;
    rib_cage.name = "rib_cage";
    rib_cage.particles = not_claimed(mesh, claimed);
    carry(rib_cage, model);
  }
  require_free_parts_off(surface_of, parts, model);
  const auto places = places_of(mesh);
  for (const auto& [particle, body] : surface_of) {
    const auto place = places.find(particle);
    if (place == places.end() || place->second.row == 0)
      throw InputError(
          body < static_cast<int>(parts.size()) ? parts[static_cast<std::size_t>(body)].at : Place{},
          fmt::format("particle {} cannot slide along a rigid surface", particle),
          "one on a muscle line between the costal insertion and the top of the zone of apposition");
    model.supports.push_back(support_at(mesh, particle, place->second, body));
  }
  model.friction = tissue.rib_friction;
}

}  // namespace trunk
