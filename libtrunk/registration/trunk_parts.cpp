#include "registration/trunk_parts.hpp"

#include <algorithm>
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

std::vector<Triangle> outside_of(const TrunkMesh& mesh) {
  std::vector<Triangle> outside = abdominal_wall_of(mesh);
  append(rib_side_of(mesh), outside);
  return outside;
}

}  // namespace trunk
