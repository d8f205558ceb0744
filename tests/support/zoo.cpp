#include "support/zoo.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/volume.hpp"

namespace trunk::test {
namespace {

Mesh outward(Mesh mesh) {
  if (enclosed_volume<double>(mesh.triangles, mesh.position) < 0.0)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Every edge cut in two, every triangle in four; the new particles are shared by both sides of an edge.
Mesh subdivided(const Mesh& coarse) {
  Mesh fine{coarse.name, {}, coarse.position};
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](int a, int b) {
    const auto [at, is_new] = middle.try_emplace(std::minmax(a, b), static_cast<int>(fine.position.size()));
    if (is_new)
      fine.position.push_back(
          0.5 * (fine.position[static_cast<std::size_t>(a)] + fine.position[static_cast<std::size_t>(b)]));
    return at->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    for (const Triangle& t :
         {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

}  // namespace

Mesh tetrahedron(double edge) {
  const double s = edge / std::sqrt(8.0);
  return outward({"tetrahedron",
                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                  {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}}});
}

Mesh box(double x, double y, double z) {
  Mesh mesh{"box", {}, {}};
  for (int i = 0; i < 8; ++i)
    mesh.position.emplace_back((i & 1 ? 0.5 : -0.5) * x, (i & 2 ? 0.5 : -0.5) * y, (i & 4 ? 0.5 : -0.5) * z);
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return outward(mesh);
}

Mesh bipyramid(int valence) {
  Mesh mesh{"bipyramid with poles of valence " + std::to_string(valence), {}, {{0, 0, 0.11}, {0, 0, -0.09}}};
  for (int k = 0; k < valence; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / valence;
    mesh.position.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
    const int here = 2 + k, next = 2 + (k + 1) % valence;
    mesh.triangles.push_back({here, next, 0});
    mesh.triangles.push_back({next, here, 1});
  }
  return outward(mesh);
}

Mesh octahedron(double radius) {
  Mesh mesh = bipyramid(4);
  mesh.name = "octahedron";
  for (Vec3d& p : mesh.position) p = (radius / norm(p)) * p;
  return mesh;
}

Mesh icosphere(double radius, int subdivisions) {
  const double g = std::numbers::phi;
  Mesh mesh{"icosphere " + std::to_string(subdivisions), {}, {}};
  for (const double s : {1.0, -1.0})
    for (const double t : {1.0, -1.0})
      for (const Vec3d& p : {Vec3d{0, s, t * g}, Vec3d{s, t * g, 0}, Vec3d{t * g, 0, s}})
        mesh.position.push_back(p);
  // The faces of an icosahedron of edge 2: any three particles two apart, outward.
  const auto joined = [&](std::size_t a, std::size_t b) {
    return std::abs(norm(mesh.position[a] - mesh.position[b]) - 2.0) < 1e-9;
  };
  for (std::size_t a = 0; a < 12; ++a)
    for (std::size_t b = a + 1; b < 12; ++b)
      for (std::size_t c = b + 1; c < 12; ++c) {
        if (!joined(a, b) || !joined(b, c) || !joined(c, a)) continue;
        Triangle t{static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)};
        if (dot(mesh.position[a], cross(mesh.position[b], mesh.position[c])) < 0.0) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
      }
  for (int i = 0; i < subdivisions; ++i) {
    mesh = subdivided(mesh);
    for (Vec3d& p : mesh.position) p = (1.0 / norm(p)) * p;
  }
  for (Vec3d& p : mesh.position) p = (radius / norm(p)) * p;
  return mesh;
}

Mesh torus() {
  constexpr int around = 9, across = 5;
  Mesh mesh{"torus", {}, {}};
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2.0 * std::numbers::pi * i / around, b = 2.0 * std::numbers::pi * j / across;
      const double radius = 0.1 + 0.04 * std::cos(b);
      mesh.position.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.04 * std::sin(b));
      const auto at = [&](int u, int v) { return (u % around) * across + v % across; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return outward(mesh);
}

Mesh two_tetrahedra() {
  Mesh mesh = tetrahedron(0.1);
  mesh.name = "two tetrahedra";
  for (std::size_t i = 0; i < 4; ++i) {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    mesh.position.push_back(mesh.position[i] + Vec3d{0.3, 0.1, 0.0});
  }
  return mesh;
}

Mesh star() {
  Mesh mesh = icosphere(0.1, 1);
  mesh.name = "star";
  for (std::size_t i = 0; i < 12; ++i)
    mesh.position[i] = 2.5 * mesh.position[i];  // the icosahedron's own corners
  return mesh;
}

std::vector<Mesh> closed_meshes() {
  std::vector<Mesh> meshes{
      tetrahedron(0.1), box(0.2, 0.1, 0.15), octahedron(0.1), icosphere(0.1, 0), icosphere(0.1, 1),
      torus(),          two_tetrahedra(),    star()};
  for (int valence = 3; valence <= 9; ++valence) meshes.push_back(bipyramid(valence));
  return meshes;
}

std::vector<Mesh> closed_meshes_with_valence(std::size_t valence) {
  std::vector<Mesh> meshes = closed_meshes();
  std::erase_if(meshes, [&](const Mesh& mesh) {
    const Surface surface = mesh.surface();
    return std::none_of(surface.one_rings().begin(), surface.one_rings().end(),
                        [&](const auto& ring) { return ring.neighbours.size() == valence; });
  });
  return meshes;
}

std::vector<Vec3d> deformed(std::vector<Vec3d> position, double size, Random& random) {
  for (Vec3d& p : position) p += random.vector(size);
  return position;
}

RigidMotion random_motion(Random& random) {
  const Vec3d a = random.vector(1.0), b = random.vector(1.0);
  const Vec3d u = (1.0 / norm(a)) * a, w = cross(u, b);
  const Vec3d n = (1.0 / norm(w)) * w;
  return {{u, cross(n, u), n}, random.vector(1.0)};
}

}  // namespace trunk::test
