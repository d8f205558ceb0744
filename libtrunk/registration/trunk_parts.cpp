#include "registration/trunk_parts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace trunk {
namespace {

/// Returns the triangles with every corner in one of the regions.
std::vector<Triangle> between(const TrunkMesh& mesh, const std::vector<Triangle>& triangles,
                              std::initializer_list<const char*> regions) {
  std::set<int> particles;
  for (const char* region : regions) particles.insert(mesh.named(region).begin(), mesh.named(region).end());
  std::vector<Triangle> found;
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(found), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int i) { return particles.contains(i); });
  });
  return found;
}

void append(const std::vector<Triangle>& more, std::vector<Triangle>& to) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Triangle> diaphragm_of(const TrunkMesh& mesh) {
  return between(mesh, mesh.abdomen,
                 {"costal_insertion", "zone_of_apposition", "muscular_dome", "central_tendon"});
}

std::vector<Triangle> abdominal_wall_of(const TrunkMesh& mesh) {
  std::vector<Triangle> wall = between(mesh, mesh.abdomen, {"pelvis", "abdominal_wall"});
  std::set<int> pelvis(mesh.named("pelvis").begin(), mesh.named("pelvis").end());
  std::erase_if(wall, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int i) { return pelvis.contains(i); });
  });
  return wall;
}

std::vector<Triangle> rib_side_of(const TrunkMesh& mesh) {
  std::vector<Triangle> side = between(mesh, mesh.abdomen, {"costal_insertion", "zone_of_apposition"});
  // The lung has the dome, too, which faces down there: triangles of the wall have a corner that the dome has
  // not.
  std::set<int> wall(mesh.named("lung_wall").begin(), mesh.named("lung_wall").end());
  wall.insert(mesh.named("lung_top").begin(), mesh.named("lung_top").end());
  for (const Triangle& t : mesh.lung)
    if (std::any_of(t.begin(), t.end(), [&](int i) { return wall.contains(i); })) side.push_back(t);
  return side;
}

std::vector<Triangle> side_of(const TrunkMesh& mesh, const std::vector<Triangle>& surface, double sign) {
  const auto x = [&](int i) { return mesh.rest[static_cast<std::size_t>(i)].x(); };
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Triangle& t : surface)
    for (const int i : t) {
      low = std::min(low, x(i));
      high = std::max(high, x(i));
    }
  const double middle = 0.5 * (low + high);
  std::vector<Triangle> side;
  std::copy_if(surface.begin(), surface.end(), std::back_inserter(side), [&](const Triangle& t) {
    return sign * ((x(t[0]) + x(t[1]) + x(t[2])) / 3.0 - middle) > 0.0;
  });
  return side;
}

MeasuredSurface with_mirror_image(const MeasuredSurface& half, double x) {
  MeasuredSurface whole = half;
  const int before = static_cast<int>(half.points.size());
  for (const Vec3d& p : half.points) whole.points.emplace_back(2.0 * x - p.x(), p.y(), p.z());
  for (const Triangle& t : half.triangles)
    whole.triangles.push_back({t[0] + before, t[2] + before, t[1] + before});
  return whole;
}

std::vector<Triangle> outside_of(const TrunkMesh& mesh) {
  std::vector<Triangle> outside = abdominal_wall_of(mesh);
  append(rib_side_of(mesh), outside);
  return outside;
}

}  // namespace trunk
