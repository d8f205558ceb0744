#pragma once

#include <string>
#include <vector>

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"

namespace trunk {

/// A ring of particles around the trunk, or one particle on its axis. Angles run from 0 at the subject's
/// right
/// (+x), counter-clockwise seen from above.
struct Level {
  std::vector<int> particles;
  std::vector<double> angles;  // rad, one a particle
};

/// Where the profile passes at resolution 1: the size scales the trunk's ellipse; height + tilt cos(angle).
struct Station {
  std::string region;  // of its own particles
  std::string above;   // of those between it and the next
  int count;           // particles around
  double size, height, tilt;
};

/// Adds particles to a mesh, level by level.
class LevelBuilder {
 public:
  LevelBuilder(const TrunkGeometry& geometry, TrunkMesh& mesh) : geometry_(geometry), mesh_(mesh) {}

  /// A ring of `count` particles, or one on the axis.
  Level level(const std::string& region, int count, double size, double height, double tilt);

  /// The levels of a profile at the geometry's resolution, those of the stations among them.
  std::vector<Level> levels(const std::vector<Station>& stations);

 private:
  const TrunkGeometry& geometry_;
  TrunkMesh& mesh_;
};

/// Joins each level to the next, above or inside it, by triangles that face outward or up. => triangles
void join(const std::vector<Level>& levels, std::vector<Triangle>& triangles);

void turn_over(std::vector<Triangle>& triangles);

}  // namespace trunk
