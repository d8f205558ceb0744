#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace trunk {

/// The corners of a triangle: particle indices, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;

/// A closed, oriented, manifold triangulated surface. It has connectivity only, no positions.
class Surface {
 public:
  /// The neighbours of one vertex, counter-clockwise seen from outside.
  struct OneRing {
    int vertex;
    std::vector<int> neighbours;
  };

  Surface() = default;

  /// Throws InputError, which names the surface and the particle or edge, unless
  ///  - every index is in [0, particles),
  ///  - every edge belongs to exactly two triangles, which run along it in opposite directions, and
  ///  - the triangles around each vertex form one closed fan.
  Surface(std::string name, std::vector<Triangle> triangles, int particles);

  const std::string& name() const noexcept { return name_; }
  std::span<const Triangle> triangles() const noexcept { return triangles_; }
  /// Returns one entry for each vertex of the surface, by increasing particle index.
  std::span<const OneRing> one_rings() const noexcept { return one_rings_; }

 private:
  std::string name_;
  std::vector<Triangle> triangles_;
  std::vector<OneRing> one_rings_;
};

}  // namespace trunk
