#pragma once

#include <span>
#include <vector>

#include "surface/measured_surface.hpp"

namespace trunk {

/// Numbers of the connected parts, one a triangle, from 0: triangles that share a point are connected.
std::vector<int> connected_parts(std::span<const Triangle> triangles, std::size_t points);

/// Parts in which each triangle is reached from each through edges of two triangles alone.
struct Patches {
  std::vector<int> number;  // [triangles] of the patch, from 0
  std::size_t turned = 0;   // the fewest that have to be turned so that neighbours agree
  bool possible = true;     // false: one-sided, as a Moebius strip is
};

/// Turns triangles until neighbours within a patch agree on a side, whichever that is.
Patches orient_patches(std::vector<Triangle>& triangles);

/// Turns each connected part so that a closed one has a positive volume and an open one faces away from its
/// middle, or upward (+z) where it is too flat to tell.
void face_outward(MeasuredSurface& surface);

}  // namespace trunk
