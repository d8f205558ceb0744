#pragma once

#include <string>
#include <vector>

#include "anatomy/trunk_mesh.hpp"
#include "anatomy/trunk_options.hpp"

namespace trunk {

/// A ring of particles around the trunk, or one particle on its axis. Angles begin with 0 at the subject's
/// right (+x) and run counter-clockwise seen from above.
struct Level {
  std::vector<int> particles;
  std::vector<double> angles;  // [particles] rad
};

/// A ring of the profile at resolution 1. The size scales the trunk's ellipse; particles lie at
/// height + tilt cos(angle).
struct Station {
  std::string region;  // region of its own particles
  std::string above;   // region of the particles between it and the next station
  int count;           // particles around
  double size, height, tilt;
};

/// Adds particles to a mesh, level by level.
class LevelBuilder {
 public:
  LevelBuilder(const TrunkGeometry& geometry, TrunkMesh& mesh) : geometry_(geometry), mesh_(mesh) {}

  /// Adds and returns a ring of `count` particles, or one particle on the axis.
  Level level(const std::string& region, int count, double size, double height, double tilt);

  /// Adds and returns the levels of a profile at the geometry's resolution. The stations are among them.
  std::vector<Level> levels(const std::vector<Station>& stations);

 private:
  const TrunkGeometry& geometry_;
  TrunkMesh& mesh_;
};

/// Joins each level to the next, above or inside it, by triangles that face outward or up. => triangles
void join(const std::vector<Level>& levels, std::vector<Triangle>& triangles);

/// Makes all triangles face the other side.
void turn_over(std::vector<Triangle>& triangles);

}  // namespace trunk
