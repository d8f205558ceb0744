#pragma once

#include <string>
#include <vector>

#include "math/vec3.hpp"
#include "mesh/surface.hpp"
#include "support/random.hpp"

namespace trunk::test {

/// A closed surface with its positions, oriented outward.
struct Mesh {
  std::string name;
  std::vector<Triangle> triangles;
  std::vector<Vec3d> position;  // m, of the order of 0.1: the size of an organ

  Surface surface() const { return {name, triangles, static_cast<int>(position.size())}; }
};

// Single animals, centred on the origin.
Mesh tetrahedron(double edge);
Mesh box(double x, double y, double z);
Mesh octahedron(double radius);
Mesh icosphere(double radius, int subdivisions);  // 0: icosahedron
Mesh bipyramid(int valence);                      // poles of that valence, an equator of valence 4
Mesh torus();                                     // genus 1
Mesh two_tetrahedra();                            // two components
Mesh star();                                      // far from convex

/// All of them, one of each kind and bipyramids of valence 3 to 9.
std::vector<Mesh> closed_meshes();

/// Those that have a particle with that many neighbours.
std::vector<Mesh> closed_meshes_with_valence(std::size_t valence);

/// Every particle moved at random inside a cube of half edge `size`.
std::vector<Vec3d> deformed(std::vector<Vec3d> position, double size, Random& random);

/// A rotation and a shift.
struct RigidMotion {
  Vec3d column[3];
  Vec3d shift;

  Vec3d turn(const Vec3d& a) const { return a.x() * column[0] + a.y() * column[1] + a.z() * column[2]; }
  Vec3d operator()(const Vec3d& a) const { return turn(a) + shift; }
};
RigidMotion random_motion(Random& random);

}  // namespace trunk::test
